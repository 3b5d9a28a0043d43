#include "identification/evaluation/goodness_of_fit.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "identification/evaluation/outliers.h"
#include "identification/least_squares/robust_weights.h"

namespace artcal {
namespace {

/// Sums over the observations that are no outliers.
class RobustSums {
 public:
  RobustSums(Loss loss, double observations) : moments_(loss), observations_(observations) {}

  void add(double squares, int dimension, double weight, const Check& check) {
    const double size = standardised(squares, dimension, check);
    if (size > outlier_limit(observations_, check)) {
      outlying_ += dimension;
      return;
    }
    const LossMoments& moments = moments_.at(check.freedom);
    const double expected = dimension * check.variance;
    sum_ += weight * weight * squares / moments.square;
    expected_ += expected;
    variance_ += expected * expected * moments.variance / (moments.square * moments.square);
  }

  [[nodiscard]] GoodnessOfFit result(int degrees_of_freedom) const {
    GoodnessOfFit fit;
    fit.degrees_of_freedom = std::max(1, degrees_of_freedom - outlying_);
    if (!(expected_ > 0.0 && variance_ > 0.0)) {
      return fit;
    }
    fit.chi_squared = sum_ * fit.degrees_of_freedom / expected_;
    // A χ² of so many degrees of freedom has the same relative variance.
    const double equivalent = 2.0 * expected_ * expected_ / variance_;
    fit.low = fit.degrees_of_freedom * chi_squared_quantile(0.025, equivalent) / equivalent;
    fit.high = fit.degrees_of_freedom * chi_squared_quantile(0.975, equivalent) / equivalent;
    return fit;
  }

 private:
  MomentsTable moments_;
  double observations_;
  double sum_ = 0.0, expected_ = 0.0, variance_ = 0.0;
  int outlying_ = 0;
};

}  // namespace

GoodnessOfFit goodness_of_fit(const Constraints& constraints, const ArmFit& fit, Loss loss,
                              const Redundancy& redundancy) {
  if (loss == Loss::None) {
    const double chi_squared = fit.residuals.readings_squared() + fit.residuals.certificates_squared();
    return {chi_squared, fit.degrees_of_freedom, chi_squared_quantile(0.025, fit.degrees_of_freedom),
            chi_squared_quantile(0.975, fit.degrees_of_freedom), std::sqrt(chi_squared / fit.degrees_of_freedom)};
  }
  RobustSums sums(loss, observation_count(constraints));
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const int dimension = constraints.features[f].dimension();
    for (std::size_t k = 0; k < redundancy.readings[f].size(); ++k) {
      const auto residual =
          Eigen::VectorXd::Map(fit.residuals.readings[f].data() + k * static_cast<std::size_t>(dimension), dimension);
      sums.add(residual.squaredNorm(), dimension, fit.loss_weights.readings[f][k], redundancy.readings[f][k]);
    }
  }
  std::size_t binding = 0;
  for (std::size_t d = 0; d < constraints.distances.size(); ++d) {
    if (constraints.distances[d].binds) {
      const double r = fit.residuals.distances[binding++];
      sums.add(r * r, 1, fit.loss_weights.distances[d], redundancy.distances[d]);
    }
  }
  for (std::size_t s = 0; s < constraints.shared.size(); ++s) {
    if (constraints.shared[s].u > 0.0) {
      sums.add(fit.residuals.shared[s] * fit.residuals.shared[s], 1, fit.loss_weights.shared[s], redundancy.shared[s]);
    }
  }
  GoodnessOfFit agreement = sums.result(fit.degrees_of_freedom);
  agreement.ratio = median_noise_factor(fit.residuals, redundancy);
  return agreement;
}

}  // namespace artcal
