#pragma once

#include "identification/least_squares/linearisation.h"

namespace artcal {

/// The weighted residuals at a point, split by the tangent space of the model there.
struct ResidualParts {
  double tangential = 0.0;  ///< what a linear step takes away, ‖P r‖; zero where the sum of squares is stationary
  double orthogonal = 0.0;  ///< what it leaves, ‖(1 − P) r‖
};

/// The split depends on the tangent space only, not on which parameters describe it: parameters that hardly determine a
/// direction make steps small or large, but do not hide what is left to gain along it.
/// Directions below 1e-12 of the largest singular value of the arm's triangle are rounding and are left out.
ResidualParts residual_parts(const Linearisation& linearisation, int arm_size);

/// Whether the point is a minimum for practical purposes: the relative offset of Bates and Watts (1981, A relative
/// offset orthogonality convergence criterion for nonlinear least squares, Technometrics 23), the tangential part
/// against the orthogonal one, each by its degrees of freedom, is below 0.001; then the parameters are off by less than
/// a thousandth of their confidence region, and the sum of squares by less than a millionth of what a degree of freedom
/// adds to it. Or the tangential part is below `negligible`.
bool is_stationary(const ResidualParts& parts, int degrees_of_freedom, int unknowns, double negligible);

}  // namespace artcal
