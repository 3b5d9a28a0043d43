#pragma once

#include <optional>

#include <Eigen/Core>

#include "identification/least_squares/linearisation.h"
#include "identification/problem/system.h"

namespace artcal {

/// Covariance of the free parameters in mm and rad from the linearisation at a solution whose weights are
/// inverse standard deviations: (RᵀR)⁻¹ with R the arm's triangle, by its singular values (never from
/// JᵀJ). `scale` is System::scale of that linearisation. Nothing if R is singular to working precision.
std::optional<Eigen::MatrixXd> arm_covariance(const Eigen::VectorXd& scale, const Linearisation& linearisation);

/// Variances of the artefact parameters (Constraints::shared) at the same solution, mm². Nothing if they or the arm are
/// not determined.
std::optional<Eigen::VectorXd> shared_variances(const Linearisation& linearisation);

/// Whitened residuals at a solution.
struct WhitenedResiduals {
  std::vector<std::vector<double>> readings;  ///< by feature: dimension() numbers a reading
  std::vector<double> distances;              ///< of the binding distances
  std::vector<double> shared;                 ///< of Constraints::shared: found − certified; 0 where uncertified

  [[nodiscard]] double readings_squared() const;
  [[nodiscard]] double certificates_squared() const;  ///< of distances and shared
  /// The standard deviation of the readings' residuals by the median of their sizes.
  [[nodiscard]] double deviation_by_median() const;
  [[nodiscard]] std::size_t reading_count() const;  ///< of numbers, dimension() a reading
};
WhitenedResiduals whitened_residuals(const System& system, const Weights& weights, const Arm& arm,
                                     const Unknowns& unknowns);

}  // namespace artcal
