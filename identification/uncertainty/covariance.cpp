#include "identification/uncertainty/covariance.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/statistics.h"
#include "identification/identifiability/svd.h"
#include "identification/least_squares/rows.h"
#include "identification/monte_carlo/arrow_factor.h"

namespace artcal {
namespace {

double squared(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

// A with A·Aᵀ = (RᵀR)⁻¹, by singular values; nothing where R is singular to working precision.
std::optional<Eigen::MatrixXd> inverse_root(const Eigen::MatrixXd& triangle) {
  const auto [sigma, v] = svd(triangle);
  if (!(sigma.size() > 0 && sigma.minCoeff() > 1e-12 * sigma.maxCoeff())) {
    return std::nullopt;
  }
  return v * sigma.cwiseInverse().asDiagonal();
}

}  // namespace

double WhitenedResiduals::readings_squared() const {
  return std::accumulate(readings.begin(), readings.end(), 0.0,
                         [](double sum, const auto& feature) { return sum + squared(feature); });
}

double WhitenedResiduals::certificates_squared() const { return squared(distances) + squared(shared); }

double WhitenedResiduals::deviation_by_median() const {
  std::vector<double> sizes;
  for (const auto& feature : readings) {
    std::transform(feature.begin(), feature.end(), std::back_inserter(sizes), [](double r) { return std::abs(r); });
  }
  return sigma_per_median() * median(sizes);
}

std::size_t WhitenedResiduals::reading_count() const {
  std::size_t count = 0;
  for (const auto& feature : readings) {
    count += feature.size();
  }
  return count;
}

WhitenedResiduals whitened_residuals(const System& system, const Weights& weights, const Arm& arm,
                                     const Unknowns& unknowns) {
  const Constraints& constraints = *system.constraints;
  const auto kinematics_by_probe = forward_kinematics_of(system, arm);
  WhitenedResiduals residuals;
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    const GroupState& group = state_of(feature, unknowns);
    auto& out = residuals.readings.emplace_back(static_cast<std::size_t>(feature.size() * feature.dimension()));
    weighted_rows(system, feature, weights.features[f], kinematics_by_probe,
                  FeatureResidual(feature, group.reference, group.values.data(), unknowns.shared.data()), 0,
                  feature.size(), {1, out.data()});
  }
  for (std::size_t d = 0; d < constraints.distances.size(); ++d) {
    const DistanceConstraint& distance = constraints.distances[d];
    if (distance.binds) {
      const auto& values = state_of(constraints.features[distance.first], unknowns).values;
      residuals.distances.push_back(
          weighted_distance(distance, constraints, weights.distances[d], values.data(), nullptr));
    }
  }
  for (std::size_t s = 0; s < constraints.shared.size(); ++s) {
    residuals.shared.push_back(
        weighted_shared(constraints.shared[s], weights.shared[s], unknowns.shared[static_cast<Eigen::Index>(s)]));
  }
  return residuals;
}

std::optional<Eigen::MatrixXd> arm_covariance(const Eigen::VectorXd& scale, const Linearisation& linearisation) {
  const auto root = inverse_root(arm_triangle(linearisation, static_cast<int>(scale.size())));
  if (!root) {
    return std::nullopt;
  }
  const Eigen::MatrixXd scaled = scale.asDiagonal() * *root;
  return scaled * scaled.transpose();
}

std::optional<Eigen::VectorXd> shared_variances(const Linearisation& linearisation) {
  if (linearisation.layout.arm == linearisation.layout.common) {
    return Eigen::VectorXd();
  }
  const auto factor = ArrowFactor::of(linearisation);
  return factor ? std::optional(factor->parameter_variances()) : std::nullopt;
}

}  // namespace artcal
