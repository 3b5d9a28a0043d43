#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "app/history/arm_history.h"
#include "core/statistics.h"

namespace artcal {
namespace {

bool is_identified(const CalibratedParameter& parameter) { return parameter.state == "identified"; }

// Why the parameters of one are not those of the other; empty where they are.
std::string difference(const Calibration& then, const Calibration& now) {
  if (then.parameters.size() != now.parameters.size()) {
    return "the arm has other parameters";
  }
  for (std::size_t i = 0; i < then.parameters.size(); ++i) {
    const CalibratedParameter& before = then.parameters[i];
    const CalibratedParameter& after = now.parameters[i];
    if (before.name != after.name) {
      return "the arm has other parameters";
    }
    if (is_identified(before) != is_identified(after)) {
      return fmt::format("{} was identified in one and held in the other", before.name);
    }
    // Both come from files with every digit: held at the same value means the same number.
    if (!is_identified(before) && before.value != after.value) {
      return fmt::format("{} was held at {} and then at {} {}, which others make up for", before.name, before.value,
                         after.value, before.unit);
    }
  }
  return {};
}

// dᵀ C⁻¹ d, in units of the standard deviations: mm and rad differ by orders of magnitude.
double squared_distance(const Eigen::VectorXd& change, const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd correlation = scale.asDiagonal() * covariance * scale.asDiagonal();
  const Eigen::VectorXd scaled = scale.cwiseProduct(change);
  return scaled.dot(correlation.ldlt().solve(scaled));
}

// Which changes are significant; the smallest effective degrees of freedom of all.
double judge(std::vector<ParameterChange>& changes, const Calibration& then, const Calibration& now) {
  double smallest = std::numeric_limits<double>::infinity();
  for (ParameterChange& change : changes) {
    const auto component_of = [&](const Calibration& calibration) {
      const auto at = std::find_if(calibration.parameters.begin(), calibration.parameters.end(),
                                   [&](const auto& parameter) { return parameter.name == change.name; });
      return UncertaintyComponent{at->u, at->degrees_of_freedom};
    };
    const std::array<UncertaintyComponent, 2> components{component_of(then), component_of(now)};
    const double freedom = effective_degrees_of_freedom(components);
    change.limit = significance_factor(changes.size(), freedom);
    change.significant = std::abs(change.now - change.then) > change.limit * change.u;
    smallest = std::min(smallest, freedom);
  }
  return smallest;
}

}  // namespace

CalibrationStep step_between(const Calibration& then, const Calibration& now) {
  CalibrationStep step;
  std::set_intersection(then.entry.certificates.begin(), then.entry.certificates.end(), now.entry.certificates.begin(),
                        now.entry.certificates.end(), std::back_inserter(step.in_common));
  if (then.arm && now.arm) {
    step.lengths = length_change(*then.arm, *now.arm);  // lengths compare where parameters do not
  }
  step.not_comparable = difference(then, now);
  if (!step.not_comparable.empty()) {
    return step;
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i < then.parameters.size(); ++i) {
    const CalibratedParameter& before = then.parameters[i];
    const CalibratedParameter& after = now.parameters[i];
    if (is_identified(before)) {
      step.changes.push_back(
          {before.name, before.unit, before.value, after.value, std::hypot(before.u, after.u), 0.0, false});
      differences.push_back(after.value - before.value);
    }
  }
  const double freedom = judge(step.changes, then, now);
  if (!differences.empty()) {
    const Eigen::Map<const Eigen::VectorXd> change(differences.data(), static_cast<Eigen::Index>(differences.size()));
    step.chi_squared = squared_distance(change, then.covariance + now.covariance);
    // Hotelling's T² of an estimated noise; χ² of a known one.
    const auto count = static_cast<double>(differences.size());
    step.limit =
        std::isinf(freedom) ? chi_squared_quantile(0.95, count) : count * f_quantile_above(0.05, count, freedom);
  }
  return step;
}

}  // namespace artcal
