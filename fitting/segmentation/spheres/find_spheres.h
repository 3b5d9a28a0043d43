#pragma once

#include <string>
#include <vector>

#include "fitting/fit.h"

namespace artcal {

struct SphereSearch {
  std::vector<double> radii;  ///< that are looked for, mm, each > 0; equal ones count once
  /// How far the radius that the points show may be from the one looked for, as a share of it; what the points
  /// leave uncertain comes on top.
  double radius_tolerance = 0.02;
  /// Centres of spheres whose radius is known are told by the known radius; a scanner that reads balls too
  /// large or too small is then seen in `seen_radius`.
  bool fixed_radius = true;
  /// By how much the frame that the points stand in may bend a sphere, mm: points that an arm gives which is not
  /// identified yet are not quite round. Widens what is allowed of the radius and of the roundness.
  double distortion = 0.0;
};

/// A sphere in a scan. Lengths in mm, in the frame of the points.
struct FoundSphere {
  Fitted<Sphere> fitted;       ///< of `points`, in their order
  std::vector<int> points;     ///< columns of its points, ascending
  double radius_wanted = 0.0;  ///< the one of SphereSearch::radii that it answers
  double seen_radius = 0.0;    ///< of the sphere through its points when the radius is left free
  double u_seen_radius = 0.0;  ///< standard uncertainty of that, from the points' noise
  double coverage = 0.0;       ///< share of the sphere's surface that was seen, 0 to 1
  int left_out = 0;            ///< points within a fifth of the radius of its surface that are not its own
};

enum class RejectionReason {
  TooFewPoints,
  TooLittleSeen,  ///< so small a part of the surface does not determine a sphere from anything else
  WrongRadius,
  NotASphere,  ///< points scatter about it, or only touch it: stem, cylinder, edge, table
  Overlaps,    ///< a better sphere stands there
  Stray,       ///< a sphere of the right radius that the distances have no use for
};

/// What looked like a sphere and is none, or none of those wanted.
struct RejectedSphere {
  Sphere sphere;
  int points = 0;
  RejectionReason reason = RejectionReason::NotASphere;
  std::string why;  ///< a sentence for a person
};

struct SphereSearchResult {
  std::vector<FoundSphere> spheres;      ///< most points first
  std::vector<RejectedSphere> rejected;  ///< every place tried and not taken, most points first, at most 200
};

/// Finds the spheres of known radius in a scan: the points of each, and only those. Stems, tables, mixed pixels
/// and other surfaces that touch a ball are told from it (docs/segmentation.md). The same points give the same
/// answer, in whatever order they come, but for rounding; time goes with their number.
///
/// Errors: BadInput for NaN, more than 2³¹ points or points spread over more than two million times a radius;
/// Usage for a radius or tolerance that is not above zero. Finding nothing is no error.
Expected<SphereSearchResult> find_spheres(const Points& points, const SphereSearch& search);

}  // namespace artcal
