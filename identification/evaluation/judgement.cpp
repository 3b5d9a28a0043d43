#include "identification/evaluation/judgement.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/arm/joint_error_keys.h"
#include "core/statistics.h"
#include "core/units.h"
#include "identification/evaluation/feature_plausibility.h"

namespace artcal {
namespace {

constexpr double a_slip = 0.3;  // mm; what stands out by more is worth a warning
constexpr std::size_t max_readings_named = 5;
constexpr std::string_view opening = "no arm fits these readings: ";
// What to do where nothing points to a cause.
constexpr std::string_view general_advice =
    "Look for readings under another feature's name, a wrong certified value, a wrong radius of the tip, and joint "
    "order, signs and units of the arm's file; --model auto searches for unmodelled errors";

}  // namespace

std::string warning_of(const GoodnessOfFit& goodness_of_fit, double scale_factor, const Noise& noise) {
  if (!noise.is_given()) {
    return "";
  }
  if (goodness_of_fit.chi_squared > goodness_of_fit.high) {
    return fmt::format(
        "the residuals are {:.2f} times the stated noise, more than chance allows: the noise is larger, or the arm has "
        "errors this model does not know; all standard uncertainties were multiplied by that factor (Birge ratio)",
        scale_factor);
  }
  if (goodness_of_fit.chi_squared < goodness_of_fit.low) {
    return fmt::format(
        "the residuals are only {:.2g} times the stated noise: the noise is stated too large, and so are the standard "
        "uncertainties",
        goodness_of_fit.ratio);
  }
  return "";
}

Expected<void> check_joint_errors(const std::vector<IdentifiedParameter>& parameters) {
  std::string absurd, names;
  for (const IdentifiedParameter& p : parameters) {
    const bool found = p.state == ParameterState::Identified || p.state == ParameterState::Weak;
    if (found && p.parameter.is_joint_error() &&
        (!(std::abs(p.identified) <= most_of(p.parameter.kind)) ||
         (p.parameter.kind == ParameterKind::Compliance && p.identified < 0.0))) {
      absurd += fmt::format("{}{} = {:.3g} with a standard uncertainty of {:.2g}", absurd.empty() ? "" : ", ",
                            p.parameter.name, p.identified, p.u);
      names += (names.empty() ? "" : ",") + p.parameter.name;
    }
  }
  if (absurd.empty()) {
    return {};
  }
  return no_solution(
      fmt::format("no joint that works has such errors: {} (rad, rad/rad, rad/(N mm), 1/K); these "
                  "readings hardly determine them. Leave the group out of the model, or fix them: --hold {}",
                  absurd, names));
}

std::vector<std::string> suspicions(const Identification& result, double length) {
  std::vector<std::string> warnings;
  for (const auto& parameter : result.parameters) {
    const double moved = std::abs(parameter.identified - parameter.nominal);
    if (parameter.parameter.is_angle() && moved > 5.0 * units::degree) {
      warnings.push_back(
          fmt::format("{} moved by {:.3g} deg from its nominal value: are joint order, signs and units "
                      "right?",
                      parameter.parameter.name, moved / units::degree));
    } else if (parameter.parameter.is_length() && moved > 0.05 * length) {
      warnings.push_back(fmt::format("{} moved by {:.4g} mm from its nominal value: is this the arm that was read?",
                                     parameter.parameter.name, moved));
    }
  }
  if (!result.noise_is_given && result.noise < 1e-6) {
    warnings.push_back(
        "the readings agree to the last digits, as no real ones do: the standard uncertainties say nothing about a "
        "real arm");
  }
  if (const auto strange = implausible_feature_text(result.after, a_slip)) {
    warnings.push_back(*strange);
  }
  if (result.after.overall.rms > result.before.overall.rms) {
    warnings.push_back("the identified arm fits the readings no better than the nominal one");
  }
  double squares = 0.0;
  int count = 0;
  for (const auto& left : result.left_out) {
    squares += left.deviation.readings * left.deviation.rms * left.deviation.rms;
    count += left.deviation.readings;
  }
  if (count > 0 && std::sqrt(squares / count) > 1.5 * result.after.overall.rms) {
    warnings.push_back(
        fmt::format("placements that were left out fit {:.1f} times worse than those identified from: "
                    "the readings are few, or too much alike, for so many parameters",
                    std::sqrt(squares / count) / result.after.overall.rms));
  }
  return warnings;
}

std::string warning_of_weak_prior(const std::vector<std::string>& names, std::size_t identified) {
  if (names.empty()) {
    return "";
  }
  return fmt::format(
      "these readings alone do not determine {} within 10 mm or 3 deg, and the estimation does not converge to a "
      "plausible arm: a weak prior about the nominal values (standard deviation 10 mm or 3 deg) was added, which "
      "decides {} of {} parameters and is counted in the uncertainties. More varied postures, or --hold, make it "
      "unnecessary",
      fmt::join(names, ", "), names.size(), identified);
}

Error misfit_error(const std::vector<std::string>& misfits, int attempts, const std::vector<std::string>& where) {
  std::string found = fmt::format("{}{} ({} initial alignment{} tried)", opening, fmt::join(misfits, "; "), attempts,
                                  attempts == 1 ? "" : "s");
  std::string advice;
  if (!where.empty()) {
    const std::size_t shown = std::min(where.size(), max_readings_named);
    found += fmt::format(
        ". An arm fits all but {} reading{}: {}{}. Correct or remove {}. --loss cauchy identifies without "
        "{}",
        where.size(), where.size() == 1 ? "" : "s",
        fmt::join(where.begin(), where.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
        shown < where.size() ? ", …" : "", where.size() == 1 ? "it" : "them", where.size() == 1 ? "it" : "them");
  } else {
    advice = fmt::format(". {}", general_advice);
  }
  std::string message = fmt::format("{}{}; --accept-misfit writes the arm all the same", found, advice);
  std::string reason = misfits.size() > 1 ? misfits.front() : found.substr(opening.size());
  return {ErrorCode::NoSolution, std::move(message), {}, ErrorKind::Misfit, std::move(found), std::move(reason)};
}

Error with_reason(Error error, const Recording& recording, const Constraints& constraints, const Arm& start) {
  const auto evaluation = evaluate(recording, constraints, start);
  if (const auto strange = evaluation ? implausible_feature_text(*evaluation, another_place) : std::nullopt) {
    error.message = fmt::format("{}{}; {}", opening, *strange, error.message);
    error.kind = ErrorKind::Misfit;
    error.reason = *strange;
  } else if (const auto gross = evaluation ? grossly_different_length(*evaluation) : std::nullopt) {
    error.message = *gross + "; " + error.message;
    error.reason = *gross;
  }
  return error;
}

}  // namespace artcal
