#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/segmentation/pattern/match.h"
#include "fitting/segmentation/planes/find_planes.h"
#include "fitting/segmentation/spheres/find_spheres.h"

namespace artcal {

/// What an artefact's certificate says that a scan of it shows. Lengths in mm.
struct ScanContents {
  std::vector<double> radii;  ///< of the spheres, one each
  /// Between the spheres' centres, symmetric; NaN where the certificate does not say.
  Eigen::MatrixXd distances;
  int planes = 0;
};

struct SegmentOptions {
  /// Largest deviation of a distance between centres, mm. Without it a tenth of the smallest radius, which leaves
  /// room for an arm that is not identified yet.
  std::optional<double> tolerance;
  double radius_tolerance = 0.02;  ///< SphereSearch::radius_tolerance
  bool fixed_radius = true;        ///< SphereSearch::fixed_radius
  double distortion = 0.0;         ///< SphereSearch::distortion
  std::vector<PlaceHint> hints;    ///< by index into ScanContents::radii
};

enum class SegmentStatus {
  Complete,   ///< every feature was found, and which is which is told
  Partial,    ///< told, but something is missing
  Ambiguous,  ///< spheres were found, but several ways of naming them fit the distances
  NoMatch,    ///< spheres were found, but no way of naming them fits
  NotThere,   ///< a hint states a place where no sphere was found: Matching::unmet
  Nothing,    ///< no feature was found
};

struct Segmentation {
  SegmentStatus status = SegmentStatus::Nothing;
  /// Complete and Partial: by the order of ScanContents::radii, what is missing is absent. Else all that were found,
  /// most points first, and `matching` says by index which ways of naming them there are.
  std::vector<std::optional<FoundSphere>> spheres;
  std::vector<FoundPlane> planes;        ///< most points first
  std::vector<RejectedSphere> rejected;  ///< strays too
  Matching matching;                     ///< into the found spheres by number of points, strays included
  double tolerance = 0.0;                ///< of distances, that was used, mm
  std::vector<std::string> warnings;     ///< such as a scan that looks like another unit
};

/// The features of an artefact in a scan: which points are theirs, the features fitted to them, and which is which.
/// The same points give the same answer. Errors: as find_spheres and match. Finding nothing is a status.
Expected<Segmentation> segment(const Points& points, const ScanContents& wanted, const SegmentOptions& options = {});

}  // namespace artcal
