#pragma once

#include <Eigen/Core>

#include "identification/system.h"

namespace artcal {

/// The whole system linearised at an arm and its unknowns: the triangle R (at most arm_size() rows) whose
/// RᵀR is the normal matrix of the arm's free parameters after the unknowns of every group have been
/// eliminated. Columns are in physical units (System::scale), rows are weighted.
Eigen::MatrixXd arm_triangle(const System& system, const Weights& weights, const Arm& arm, const Unknowns& unknowns);

}  // namespace artcal
