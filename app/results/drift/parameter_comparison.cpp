#include "app/results/drift/parameter_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

#include "app/results/drift/gauge.h"
#include "app/results/result_names.h"
#include "core/statistics.h"

namespace artcal {
namespace {

GaugedParameters gauged(const CalibratedParameters& calibration) {
  GaugedParameters gauged;
  gauged.values.resize(static_cast<Eigen::Index>(calibration.parameters.size()));
  for (Eigen::Index i = 0; i < gauged.values.size(); ++i) {
    const CalibratedParameter& parameter = calibration.parameters[static_cast<std::size_t>(i)];
    gauged.names.push_back(parameter.name);
    gauged.is_angle.push_back(parameter.unit == "rad");
    gauged.values[i] = parameter.value;
    if (is_identified(parameter)) {
      gauged.estimated.push_back(i);
    }
  }
  gauged.covariance = calibration.covariance;
  gauged.unidentifiable = calibration.unidentifiable.rows() == gauged.values.size()
                              ? calibration.unidentifiable
                              : Eigen::MatrixXd::Zero(gauged.values.size(), 0);
  return gauged;
}

// dᵀ C⁻¹ d, in units of the standard deviations: mm and rad differ by orders of magnitude.
double squared_distance(const Eigen::VectorXd& change, const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd correlation = scale.asDiagonal() * covariance * scale.asDiagonal();
  const Eigen::VectorXd scaled = scale.cwiseProduct(change);
  return scaled.dot(correlation.ldlt().solve(scaled));
}

// Of u of a parameter; where it is fixed, of the poorest known one, of which it takes over a part.
double freedom_of(const CalibratedParameters& calibration, std::size_t parameter) {
  if (is_identified(calibration.parameters[parameter])) {
    return calibration.parameters[parameter].degrees_of_freedom;
  }
  double smallest = std::numeric_limits<double>::infinity();
  for (const CalibratedParameter& other : calibration.parameters) {
    smallest = std::min(smallest, other.degrees_of_freedom);
  }
  return smallest;
}

// Which changes are significant; the smallest effective degrees of freedom of all.
double judge(std::vector<ParameterChange>& changes, const CalibratedParameters& then, const CalibratedParameters& now,
             const Eigen::MatrixXd& covariance_now) {
  double smallest = std::numeric_limits<double>::infinity();
  std::size_t k = 0;
  for (std::size_t i = 0; i < then.parameters.size(); ++i) {
    if (!is_identified(then.parameters[i])) {
      continue;
    }
    ParameterChange& change = changes[k];
    const double u_now = std::sqrt(covariance_now(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)));
    change.u = std::hypot(then.parameters[i].u, u_now);
    const std::array<UncertaintyComponent, 2> components{
        {{then.parameters[i].u, then.parameters[i].degrees_of_freedom}, {u_now, freedom_of(now, i)}}};
    const double freedom = effective_degrees_of_freedom(components);
    change.limit = significance_factor(changes.size(), freedom);
    change.expanded = stated_coverage_factor(freedom) * change.u;
    change.significant = std::abs(change.now - change.then) > change.limit * change.u;
    smallest = std::min(smallest, freedom);
    ++k;
  }
  return smallest;
}

}  // namespace

bool is_identified(const CalibratedParameter& parameter) {
  return parameter.state == result_name(ParameterState::Identified) ||
         parameter.state == result_name(ParameterState::Weak);
}

ParameterComparison compare(const CalibratedParameters& then, const CalibratedParameters& now) {
  const InGauge stated = in_gauge_of(gauged(then), gauged(now));
  ParameterComparison comparison;
  comparison.not_comparable = stated.not_comparable;
  comparison.moved = stated.moved;
  if (!comparison.not_comparable.empty()) {
    return comparison;
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i < then.parameters.size(); ++i) {
    const CalibratedParameter& before = then.parameters[i];
    const double after = stated.values[static_cast<Eigen::Index>(i)];
    if (is_identified(before)) {
      comparison.changes.push_back({before.name, before.unit, before.value, after, 0.0, 0.0, 0.0, false});
      differences.push_back(after - before.value);
    }
  }
  const double freedom = judge(comparison.changes, then, now, stated.covariance);
  if (!differences.empty()) {
    const Eigen::Map<const Eigen::VectorXd> change(differences.data(), static_cast<Eigen::Index>(differences.size()));
    comparison.chi_squared = squared_distance(change, then.covariance + stated.covariance);
    // Hotelling's T² of an estimated noise; χ² of a known one.
    const auto count = static_cast<double>(differences.size());
    comparison.limit =
        std::isinf(freedom) ? chi_squared_quantile(0.95, count) : count * f_quantile_above(0.05, count, freedom);
  }
  return comparison;
}

}  // namespace artcal
