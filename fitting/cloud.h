#pragma once

#include <string_view>

#include "fitting/fit.h"

namespace artcal::fitting {

/// Points made ready for the arithmetic: checked, those of weight zero left out, the centroid removed,
/// lengths divided by their size. A fit works here and comes back through `centroid` and `scale`.
struct Cloud {
  Eigen::Matrix3Xd points;       ///< centred, and of root-mean-square length 1
  Eigen::VectorXd root_weights;  ///< √w of each; empty where all are equal
  Eigen::Vector3d centroid;      ///< weighted; mm
  double scale = 1.0;            ///< mm per unit
  double rounding = 0.0;         ///< what the storage of the coordinates alone makes of a distance; units
  Eigen::Matrix3d axes;          ///< principal directions, widest first; right-handed
  Eigen::Vector3d spread;        ///< singular values of the weighted centred points along them

  [[nodiscard]] Eigen::Index size() const { return points.cols(); }
  [[nodiscard]] double root_weight(Eigen::Index i) const { return root_weights.size() == 0 ? 1.0 : root_weights(i); }
  [[nodiscard]] double total_weight() const;
};

/// What a feature asks of its points, to be refused with a sentence that names it.
struct Requirement {
  std::string_view feature;  ///< "sphere"
  int points;                ///< fewest that determine it
  int dimensions;            ///< 1: not all equal; 2: not on a line; 3: not in a plane
};

/// Errors: BadInput for not-a-number, too few, all equal and weights that do not fit; NoSolution where the
/// points span fewer dimensions than demanded, up to the rounding of their coordinates.
Expected<Cloud> make_cloud(const Points& points, const Eigen::VectorXd& weights, const Requirement& requirement);

/// The same points, their axes turned: the third along `normal`, the others the principal directions across it.
/// REQUIRES a normal other than zero.
void turn_axes(Cloud& cloud, const Eigen::Vector3d& normal);

/// The first point that holds a NaN or an infinity, or -1.
Eigen::Index first_not_finite(const Points& points);

}  // namespace artcal::fitting
