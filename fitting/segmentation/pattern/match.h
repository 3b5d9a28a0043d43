#pragma once

#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/error.h"
#include "fitting/segmentation/pattern/place_hint.h"

namespace artcal {

/// What a certificate says of points (centres of spheres) by which they can be distinguished.
struct Pattern {
  std::vector<double> radii;  ///< one a point, mm; only found points of the same radius answer it
  /// Symmetric, mm; NaN where the certificate does not say.
  Eigen::MatrixXd distances;
  double tolerance = 1.0;  ///< largest deviation of a distance, mm
};

/// A point as it was found.
struct FoundPoint {
  Eigen::Vector3d at;  ///< mm
  double radius;       ///< of the pattern's radii, the one it answers
};

struct Assignment {
  std::vector<int> found;  ///< for each point of the pattern an index into the found ones, or -1: it is missing
  int count = 0;           ///< of those that are not missing
  double rms = 0.0;        ///< of the deviations of all distances that are certified and found, mm
  double worst = 0.0;      ///< the largest, without sign
};

struct Matching {
  /// All ways to lay the pattern over most of the found points with every distance inside the tolerance, the
  /// smallest deviation first. One: the points are told. Several: the artefact's distances do not determine them
  /// apart. None: nothing fits.
  std::vector<Assignment> ways;
  bool there_are_more = false;   ///< than the 1000 ways listed
  std::vector<UnmetHint> unmet;  ///< hints that no found point answers; there are no ways then
};

/// Finds which found points are which of the pattern's. Up to half may be missing, any number of strays stand beside;
/// a pattern of two or more points needs two. Nothing is chosen where several ways fit: not the one with the smaller
/// deviation either, for an arm that is not calibrated yet deviates by more.
///
/// Errors: Usage for sizes that differ, a tolerance not above zero, a hint for a point that is not there; NoSolution
/// where the distances say so little that the ways cannot be counted.
Expected<Matching> match(const Pattern& pattern, const std::vector<FoundPoint>& found,
                         const std::vector<PlaceHint>& hints = {});

}  // namespace artcal
