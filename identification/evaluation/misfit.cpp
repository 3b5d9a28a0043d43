#include "identification/evaluation/misfit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "core/units.h"
#include "identification/evaluation/feature_plausibility.h"

namespace artcal {
namespace {

constexpr double max_noise_ratio = 10.0;
// What errors that a model lacks may add to the noise: 20 arcsec of one encoder at full reach.
constexpr double max_unmodelled_per_reach = 1e-4;
constexpr double min_max_unmodelled = 0.1;  // mm
constexpr double max_noise_per_reach = 5e-4;
constexpr double min_max_noise = 0.5;  // mm
constexpr double max_length_ratio = 20.0;
constexpr double max_length_change_per_reach = 0.1;
constexpr double min_max_length_change = 100.0;            // mm
constexpr double max_angle_change = 30.0 * units::degree;  // rad
constexpr double max_zero_change = 90.0 * units::degree;   // rad

double max_change(const Parameter& parameter, double reach_of_nominal) {
  if (parameter.is_length()) {
    return std::max(min_max_length_change, max_length_change_per_reach * reach_of_nominal);
  }
  return parameter.kind == ParameterKind::Theta ? max_zero_change : max_angle_change;
}

bool left_bounds(const Parameter& parameter, const Arm& nominal, double reach_of_nominal, const Arm& identified) {
  if (!parameter.is_length() && !parameter.is_angle()) {
    return false;  // joint errors have bounds of their own, see check_joint_errors()
  }
  return !(std::abs(value(identified, parameter) - value(nominal, parameter)) <=
           max_change(parameter, reach_of_nominal));
}

std::string in_unit(const Parameter& parameter, double change) {
  return parameter.is_length() ? fmt::format("{:+.4g} mm", change) : fmt::format("{:+.3g} deg", change / units::degree);
}

void judge_residuals(const ArmFit& fit, const Arm& nominal, const Noise& noise, Loss loss,
                     std::vector<std::string>& reasons) {
  const double ratio = noise_ratio(fit, loss);
  const double unmodelled = std::max(min_max_unmodelled, max_unmodelled_per_reach * reach(nominal));
  if (noise.is_given() && !(ratio <= max_noise_ratio) && !(ratio * fit.noise <= unmodelled)) {
    reasons.push_back(
        fmt::format("the residuals are {:.3g} times the stated noise, {:.3g} mm a coordinate instead of {:.3g} mm",
                    ratio, ratio * fit.noise, fit.noise));
  }
  const double possible = largest_possible_noise(nominal);
  if (!noise.is_given() && !(fit.noise <= possible)) {
    reasons.push_back(
        fmt::format("the residuals are {:.3g} mm a coordinate, more than an arm of this reach has ({:.2g} mm) where no "
                    "noise is stated",
                    fit.noise, possible));
  }
}

void judge_lengths(const ArmFit& fit, const Evaluation& after, const Noise& noise, std::vector<std::string>& reasons) {
  // By the median: what a wrong distance does to chi-squared is not to hide it.
  const double sigma = fit.noise * (noise.is_given() ? std::max(1.0, noise_ratio(fit, Loss::Huber)) : 1.0);
  double worst = max_length_ratio;
  std::string said;
  for (const LengthDeviation& length : after.lengths) {
    const double u = std::hypot(length.u, length.gain * sigma);
    if (const double ratio = std::abs(length.error) / u; !(ratio <= worst)) {
      worst = ratio;
      said = fmt::format(
          "the distance of {} and {} in placement {} is measured {:+.3g} mm off its certified {:.7g} mm, {:.3g} times "
          "its standard uncertainty",
          in_quotes(length.first.feature), in_quotes(length.second), in_quotes(length.first.placement), length.error,
          length.at_temperature, ratio);
    }
  }
  if (!said.empty()) {
    reasons.push_back(std::move(said));
  }
}

}  // namespace

double largest_possible_noise(const Arm& nominal) {
  return std::max(min_max_noise, max_noise_per_reach * reach(nominal));
}

double noise_ratio(const ArmFit& fit, Loss loss) {
  if (loss == Loss::None) {
    const double chi_squared = fit.residuals.readings_squared() + fit.residuals.certificates_squared();
    return std::sqrt(chi_squared / fit.degrees_of_freedom);
  }
  return fit.residuals.deviation_by_median();
}

bool is_plausible(const Arm& nominal, const Arm& identified, const std::vector<Parameter>& free) {
  const double whole = reach(nominal);
  return std::none_of(free.begin(), free.end(),
                      [&](const Parameter& parameter) { return left_bounds(parameter, nominal, whole, identified); });
}

std::vector<std::string> misfits(const ArmFit& fit, const Evaluation& after, const Arm& nominal,
                                 const std::vector<Parameter>& free, const Noise& noise, Loss loss) {
  std::vector<std::string> reasons;
  judge_residuals(fit, nominal, noise, loss, reasons);
  if (const auto outlier = loss == Loss::None ? implausible_feature(after, another_place) : std::nullopt) {
    reasons.push_back(*outlier);
  }
  if (loss == Loss::None) {
    judge_lengths(fit, after, noise, reasons);
  }
  const double whole = reach(nominal);
  for (const Parameter& parameter : free) {
    if (left_bounds(parameter, nominal, whole, fit.arm)) {
      const double change = value(fit.arm, parameter) - value(nominal, parameter);
      reasons.push_back(fmt::format("{} moved by {} from its nominal value, more than an arm's does", parameter.name,
                                    in_unit(parameter, change)));
    }
  }
  return reasons;
}

}  // namespace artcal
