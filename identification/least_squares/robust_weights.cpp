#include "identification/least_squares/robust_weights.h"

#include <cmath>

#include "core/statistics.h"

namespace artcal {
namespace {

// Below this an observation is adapted to, and its residual is rounding.
constexpr double least_variance_of_a_row = 1e-10;

std::vector<double> variances_of(const std::vector<Check>& checks) {
  std::vector<double> variances;
  for (const Check& check : checks) {
    variances.push_back(check.variance > least_variance_of_a_row ? check.variance : 0.0);
  }
  return variances;
}

}  // namespace

const LossMoments& MomentsTable::at(double degrees_of_freedom) {
  constexpr double steps = 20.0;
  const int key = static_cast<int>(std::lround(steps * degrees_of_freedom));
  const auto found = known_.find(key);
  return found != known_.end() ? found->second : known_.emplace(key, moments_of(loss_, key / steps)).first->second;
}

void set_variances(const Redundancy& redundancy, Weights& weights) {
  for (std::size_t f = 0; f < weights.features.size(); ++f) {
    weights.features[f].variance = variances_of(redundancy.readings[f]);
  }
  weights.distance_variance = variances_of(redundancy.distances);
  weights.shared_variance = variances_of(redundancy.shared);
}

double median_noise_factor(const WhitenedResiduals& residuals, const Redundancy& redundancy) {
  std::vector<double> factors;
  std::map<double, double> medians;  // of χ² by its degrees of freedom
  for (std::size_t f = 0; f < residuals.readings.size(); ++f) {
    const auto& checks = redundancy.readings[f];
    const std::size_t dimension = checks.empty() ? 1 : residuals.readings[f].size() / checks.size();
    for (std::size_t k = 0; k < checks.size(); ++k) {
      const Check& check = checks[k];
      if (check.variance <= least_variance_of_a_row) {
        continue;
      }
      auto [middle, is_new] = medians.try_emplace(std::round(20.0 * check.freedom) / 20.0, 0.0);
      if (is_new) {
        middle->second = chi_squared_quantile(0.5, middle->first);
      }
      const auto size = static_cast<double>(dimension);
      const double squares =
          Eigen::VectorXd::Map(residuals.readings[f].data() + k * dimension, static_cast<Eigen::Index>(dimension))
              .squaredNorm();
      factors.push_back(std::sqrt(squares * check.freedom / (size * check.variance * middle->second)));
    }
  }
  return factors.empty() ? 1.0 : median(factors);
}

Weights counted_weights(const Weights& weights, Loss loss, const LossWeights& counted, const Redundancy& redundancy) {
  MomentsTable moments(loss);
  LossWeights factors = counted;
  const auto replace = [&](std::vector<double>& slopes, const std::vector<Check>& checks) {
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      slopes[i] = std::sqrt(slopes[i] * moments.at(checks[i].freedom).information);
    }
  };
  for (std::size_t f = 0; f < factors.readings.size(); ++f) {
    replace(factors.readings[f], redundancy.readings[f]);
  }
  replace(factors.distances, redundancy.distances);
  replace(factors.shared, redundancy.shared);
  return multiplied(weights, factors);
}

}  // namespace artcal
