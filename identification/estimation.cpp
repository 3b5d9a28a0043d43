#include "identification/estimation.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text/in_quotes.h"
#include "identification/evaluation/judgement.h"
#include "identification/evaluation/outliers.h"
#include "identification/identifiability/fixed_hayati_angles.h"
#include "identification/identifiability/weak_parameters.h"
#include "identification/models/group_fit.h"

namespace artcal {
namespace {

// Relative difference of the residuals' sizes at one and the same minimum.
constexpr double same_minimum = 1e-3;
constexpr double sure_noise_ratio = 3.0;
constexpr int max_realignments = 3;

Expected<GroupFit> fitted(Expected<Preparation> preparation, const Recording& recording, const Constraints& constraints,
                          const IdentifyOptions& options, const WeakPrior& prior = {}) {
  if (!preparation) {
    return tl::unexpected(preparation.error());
  }
  auto fit = fit_arm(recording, constraints, preparation->start, preparation->free, options.noise,
                     SolveOptions{options.loss, options.max_iterations}, prior);
  return fix_undetermined_members(std::move(fit), recording, constraints, std::move(*preparation), options, prior);
}

Error hardly_determined(const std::vector<std::string>& names, bool scale) {
  return {ErrorCode::NoSolution,
          fmt::format(
              "these readings do not determine {}{}{} well enough for an estimate of the arm ({}). Take more varied "
              "readings, with a certified length among them",
              scale ? "the scale of the arm" : "", scale && !names.empty() ? " and " : "", fmt::join(names, ", "),
              scale ? "the standard uncertainty of all lengths in proportion is above 0.4 %"
                    : "standard uncertainties are above 10 mm or 3 deg"),
          {}};
}

// Whether a parameter ran away along a direction that the readings hardly determine: further from its nominal value
// than three standard deviations of the prior, with a standard uncertainty above one.
bool ran_away(const GroupFit& fitted, const Arm& nominal) {
  const auto covariance = arm_covariance(fitted.fit.scale, fitted.fit.linearisation);
  for (Eigen::Index i = 0; covariance && i < covariance->rows(); ++i) {
    const Parameter& parameter = fitted.preparation.free[static_cast<std::size_t>(i)];
    const double deviation = prior_deviation(parameter);
    const double moved = std::abs(value(fitted.fit.arm, parameter) - value(nominal, parameter));
    if (deviation > 0.0 && moved > 3.0 * deviation && (*covariance)(i, i) > deviation * deviation) {
      return true;
    }
  }
  return !covariance;
}

bool is_plausible(const Expected<GroupFit>& fitted, const Arm& nominal) {
  return fitted && is_plausible(nominal, fitted->fit.arm, fitted->preparation.free) && !ran_away(*fitted, nominal);
}

// Where the fit fails: with a weak prior on parameters that the readings hardly determine, then without it from the arm
// found. `weak` gets their names where the prior stays.
Expected<GroupFit> fitted_with_prior(Expected<GroupFit> failed, const Preparation& preparation,
                                     const Recording& recording, const Constraints& constraints,
                                     const IdentifyOptions& options, std::vector<std::string>& weak) {
  const auto found = find_weak_parameters(recording, constraints, preparation.start, preparation.free, options.noise);
  if (!found) {
    return failed;
  }
  const Arm nominal = arm_for(options.model, recording.arm);
  const auto again = [&](const Arm& start, const WeakPrior& prior) {
    return fitted(prepare_from(start, recording, constraints, options), recording, constraints, options, prior);
  };
  auto fixed = found->names.empty() ? tl::unexpected(Error{}) : again(found->arm, {found->names, nominal});
  auto whole = again(fixed ? fixed->fit.arm : found->arm, {});
  if (is_plausible(whole, nominal)) {
    return whole;
  }
  if (!is_plausible(fixed, nominal)) {
    return failed;
  }
  if (found->scale_is_weak || contradicts({found->names, nominal}, fixed->fit, fixed->preparation.free)) {
    return tl::unexpected(hardly_determined(found->names, found->scale_is_weak));
  }
  weak = found->names;
  return fixed;
}

Expected<Estimate> estimate_of(const Expected<Preparation>& preparation, Alignment alignment,
                               const Recording& recording, const Constraints& constraints,
                               const IdentifyOptions& options) {
  const Arm nominal = arm_for(options.model, recording.arm);
  auto fit = fitted(preparation, recording, constraints, options);
  std::vector<std::string> weak;
  if (preparation && !is_plausible(fit, nominal)) {
    fit = fitted_with_prior(std::move(fit), *preparation, recording, constraints, options, weak);
  }
  if (!fit) {
    return tl::unexpected(fit.error());
  }
  if (weak.empty() && is_scale_weak(fit->fit.arm, fit->preparation.free, fit->fit.linearisation, fit->fit.scale)) {
    return tl::unexpected(hardly_determined({}, true));
  }
  auto after = evaluate(recording, constraints, fit->fit.arm);
  if (!after) {
    return tl::unexpected(after.error());
  }
  auto reasons = misfits(fit->fit, *after, nominal, fit->preparation.free, options.noise, options.loss);
  return Estimate{alignment,
                  1,
                  std::move(fit->preparation),
                  std::move(fit->fit),
                  std::move(*after),
                  std::move(reasons),
                  std::move(weak),
                  std::move(fit->fixed)};
}

Expected<Estimate> estimate_from(Alignment alignment, const Recording& recording, const Constraints& constraints,
                                 const IdentifyOptions& options, const Arm* from = nullptr) {
  return estimate_of(prepare(recording, constraints, options, alignment, from), alignment, recording, constraints,
                     options);
}

// By what the least squares made small: the noise that would explain the residuals.
double residual_size(const Estimate& estimate, const IdentifyOptions& options) {
  return options.noise.is_given() ? noise_ratio(estimate.fit, options.loss) : estimate.fit.noise;
}

bool is_better(const Estimate& estimate, const Estimate& best, const IdentifyOptions& options) {
  if (estimate.misfits.empty() != best.misfits.empty()) {
    return estimate.misfits.empty();
  }
  return residual_size(estimate, options) < residual_size(best, options);
}

// Whether the residuals are of the size of the stated noise.
bool as_stated(const Estimate& estimate, const IdentifyOptions& options) {
  return options.noise.is_given() && residual_size(estimate, options) < sure_noise_ratio;
}

// The zero offsets before the rest are a way along the stylus too.
Alignment family(Alignment alignment) {
  return alignment == Alignment::JointsFirst ? Alignment::StylusCentres : alignment;
}

bool same_size(const Estimate& one, const Estimate& other, const IdentifyOptions& options) {
  return std::abs(residual_size(one, options) / residual_size(other, options) - 1.0) < same_minimum;
}

// Whether another way led to the same minimum.
bool confirms(const Estimate& estimate, const Estimate& best, const IdentifyOptions& options) {
  return estimate.misfits.empty() && family(estimate.alignment) != family(best.alignment) &&
         same_size(estimate, best, options);
}

// A wrong minimum is nearer to the right one than the nominal arm was: aligned anew from there, the fit often leaves
// it.
void improve(Estimate& estimate, const Recording& recording, const Constraints& constraints,
             const IdentifyOptions& options) {
  for (int round = 0; round < max_realignments && !as_stated(estimate, options); ++round) {
    bool better = false;
    for (const Alignment alignment : {Alignment::StylusCentres, Alignment::TipCentres}) {
      const Arm from = estimate.fit.arm;
      auto again = estimate_from(alignment, recording, constraints, options, &from);
      if (again && is_better(*again, estimate, options) && !same_size(*again, estimate, options)) {
        again->alignment = estimate.alignment;
        estimate = std::move(*again);
        better = true;
      }
    }
    if (!better) {
      return;
    }
  }
}

}  // namespace

Expected<Estimate> search_solution(const Recording& recording, const Constraints& constraints,
                                   const IdentifyOptions& options) {
  if (options.start) {
    const auto preparation = prepare_from(arm_for(options.model, *options.start), recording, constraints, options);
    if (!preparation) {
      return tl::unexpected(preparation.error());  // what is not identifiable near the solution is so at it
    }
    auto estimate = estimate_of(preparation, Alignment::None, recording, constraints, options);
    if (estimate && estimate->misfits.empty()) {
      return estimate;
    }
  }
  std::optional<Estimate> best;
  std::optional<Error> first_error;
  bool confirmed = false;
  int attempt = 0;
  const auto alignments = alignments_for(recording, constraints, arm_for(options.model, recording.arm));
  // Begun at a nominal arm that sees its features, the minimum is the right one.
  const bool starts_near = alignments.front() == Alignment::None;
  for (const Alignment alignment : alignments) {
    auto estimate = estimate_from(alignment, recording, constraints, options);
    ++attempt;
    if (!estimate) {
      if (estimate.error().code != ErrorCode::NoSolution) {
        return estimate;
      }
      first_error = first_error ? first_error : estimate.error();
      continue;
    }
    const bool near = starts_near && alignment == Alignment::None;
    if (!near || !estimate->misfits.empty()) {
      improve(*estimate, recording, constraints, options);
    }
    estimate->attempt = attempt;
    confirmed = estimate->misfits.empty() &&
                (near || as_stated(*estimate, options) || (best && confirms(*estimate, *best, options)));
    if (!best || is_better(*estimate, *best, options)) {
      best = std::move(*estimate);
    }
    if (confirmed) {
      break;
    }
  }
  if (!best) {
    return tl::unexpected(*first_error);
  }
  if (!confirmed && best->misfits.empty()) {
    best->misfits.push_back(
        fmt::format("no two of {} initial alignments led to this solution, and its residuals of {:.3g} mm a coordinate "
                    "do not show by themselves that it is the right one ({})",
                    attempt, best->fit.noise * (options.noise.is_given() ? residual_size(*best, options) : 1.0),
                    options.noise.is_given() ? "the stated noise is smaller" : "no noise is stated"));
  }
  return std::move(*best);
}

namespace {

// The observations that an arm fitted with a robust loss leaves out, if there is one that fits all others.
std::vector<std::string> observations_to_remove(const Recording& recording, const Constraints& constraints,
                                                IdentifyOptions options) {
  options.loss = Loss::Cauchy;
  const auto found = search_solution(recording, constraints, options);
  std::vector<std::string> where;
  if (!found || !found->misfits.empty()) {
    return where;
  }
  const Redundancy redundancy = redundancy_of(recording, constraints, found->fit, found->preparation.free);
  const Outliers outliers = find_outliers(recording, constraints, found->fit, redundancy, found->after);
  for (const CertificateOutlier& outlier : outliers.certificates) {
    where.push_back(fmt::format("the certified {} of artefact {} ({:+.3g} mm)", quantity_text(outlier),
                                in_quotes(outlier.name.artefact), -outlier.deviation));
  }
  for (const Outlier& outlier : outliers.readings) {
    where.push_back(fmt::format("{} ({}, {}, {:+.3g} mm)", recording.where(outlier.reading), outlier.name.placement,
                                outlier.name.feature, outlier.deviation));
  }
  return where;
}

}  // namespace

Expected<Estimate> find_estimate(const Recording& recording, const Constraints& constraints,
                                 const IdentifyOptions& options) {
  auto estimate = search_solution(recording, constraints, options);
  if (!estimate) {
    return tl::unexpected(with_fixed_hayati_angles(with_reason(estimate.error(), recording, constraints, recording.arm),
                                                   recording, constraints, options));
  }
  if (!estimate->misfits.empty() && !options.accept_misfit) {
    const auto where = observations_to_remove(recording, constraints, options);
    return tl::unexpected(with_fixed_hayati_angles(misfit_error(estimate->misfits, estimate->attempt, where), recording,
                                                   constraints, options));
  }
  return estimate;
}

}  // namespace artcal
