#pragma once

#include <Eigen/Core>

#include "identification/least_squares/linearisation.h"
#include "identification/least_squares/rows.h"
#include "identification/monte_carlo/arrow_factor.h"

namespace artcal {

/// Memory for gradient(), to be used again and again.
struct GradientScratch {
  std::vector<Block> blocks;
  RowMatrix rows;
  Eigen::VectorXd residuals;
};
GradientScratch gradient_scratch(const System& system);

/// Derivative of the cost ½Σρ by all numbers of a system (see StateLayout), exact at these numbers: Jᵀr without
/// compressing J first, which takes the larger part of a linearisation's time. `unknowns` lends its references only.
Eigen::VectorXd gradient(const System& system, const Weights& weights, Loss loss, const StateLayout& layout,
                         const Unknowns& unknowns, const Eigen::VectorXd& numbers, GradientScratch& scratch);

/// The same from a linearisation at these numbers.
Eigen::VectorXd gradient(const Linearisation& linearisation);

}  // namespace artcal
