#pragma once

#include <optional>

#include <Eigen/Core>

#include "identification/problem.h"
#include "identification/system.h"

namespace artcal {

/// Covariance of the free parameters in mm and rad at a solution: (RᵀR)⁻¹ with R the arm's triangle under
/// weights that are inverse standard deviations (never from JᵀJ). With a robust loss each reading counts
/// as the loss lets it. Nothing if the triangle is singular to working precision.
std::optional<Eigen::MatrixXd> arm_covariance(const System& system, Weights weights, const Arm& arm,
                                              const Unknowns& unknowns, Loss loss);

/// Whitened residuals at a solution.
struct WhitenedResiduals {
  std::vector<std::vector<double>> readings;  ///< by feature: dimension() numbers a reading
  std::vector<double> distances;              ///< of the binding distances

  [[nodiscard]] double readings_squared() const;
  [[nodiscard]] double distances_squared() const;
};
WhitenedResiduals whitened_residuals(const System& system, const Weights& weights, const Arm& arm,
                                     const Unknowns& unknowns);

}  // namespace artcal
