#include "identification/initial/solution_search.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

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
  return fit_groups(recording, constraints, std::move(*preparation), options, prior);
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
  const auto again = [&](const Arm& start, const WeakPrior& prior) {
    return fitted(prepare_from(start, recording, constraints, options), recording, constraints, options, prior);
  };
  auto fixed = found->names.empty() ? tl::unexpected(Error{}) : again(found->arm, {found->names, recording.arm});
  auto whole = again(fixed ? fixed->fit.arm : found->arm, {});
  if (is_plausible(whole, recording.arm)) {
    return whole;
  }
  if (!is_plausible(fixed, recording.arm)) {
    return failed;
  }
  if (found->scale_is_weak || contradicts({found->names, recording.arm}, fixed->fit, fixed->preparation.free)) {
    return tl::unexpected(hardly_determined(found->names, found->scale_is_weak));
  }
  weak = found->names;
  return fixed;
}

Expected<Candidate> candidate_from(Alignment alignment, const Recording& recording, const Constraints& constraints,
                                   const IdentifyOptions& options, const Arm* from = nullptr) {
  const auto preparation = prepare(recording, constraints, options, alignment, from);
  auto fit = fitted(preparation, recording, constraints, options);
  std::vector<std::string> weak;
  if (preparation && !is_plausible(fit, recording.arm)) {
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
  auto reasons = misfits(fit->fit, *after, recording.arm, fit->preparation.free, options.noise, options.loss);
  return Candidate{alignment,
                   1,
                   std::move(fit->preparation),
                   std::move(fit->fit),
                   std::move(*after),
                   std::move(reasons),
                   std::move(weak),
                   std::move(fit->fixed)};
}

// By what the least squares made small: the noise that would explain the residuals.
double residual_size(const Candidate& candidate, const IdentifyOptions& options) {
  return options.noise.is_given() ? noise_ratio(candidate.fit, options.loss) : candidate.fit.noise;
}

bool is_better(const Candidate& candidate, const Candidate& best, const IdentifyOptions& options) {
  if (candidate.misfits.empty() != best.misfits.empty()) {
    return candidate.misfits.empty();
  }
  return residual_size(candidate, options) < residual_size(best, options);
}

// Whether the residuals are of the size of the stated noise.
bool as_stated(const Candidate& candidate, const IdentifyOptions& options) {
  return options.noise.is_given() && residual_size(candidate, options) < sure_noise_ratio;
}

// The zero offsets before the rest are a way along the stylus too.
Alignment family(Alignment alignment) {
  return alignment == Alignment::JointsFirst ? Alignment::StylusCentres : alignment;
}

bool same_size(const Candidate& one, const Candidate& other, const IdentifyOptions& options) {
  return std::abs(residual_size(one, options) / residual_size(other, options) - 1.0) < same_minimum;
}

// Whether another way led to the same minimum.
bool confirms(const Candidate& candidate, const Candidate& best, const IdentifyOptions& options) {
  return candidate.misfits.empty() && family(candidate.alignment) != family(best.alignment) &&
         same_size(candidate, best, options);
}

// A wrong minimum is nearer to the right one than the nominal arm was: aligned anew from there, the fit often leaves
// it.
void improve(Candidate& candidate, const Recording& recording, const Constraints& constraints,
             const IdentifyOptions& options) {
  for (int round = 0; round < max_realignments && !as_stated(candidate, options); ++round) {
    bool better = false;
    for (const Alignment alignment : {Alignment::StylusCentres, Alignment::TipCentres}) {
      const Arm from = candidate.fit.arm;
      auto again = candidate_from(alignment, recording, constraints, options, &from);
      if (again && is_better(*again, candidate, options) && !same_size(*again, candidate, options)) {
        again->alignment = candidate.alignment;
        candidate = std::move(*again);
        better = true;
      }
    }
    if (!better) {
      return;
    }
  }
}

}  // namespace

Expected<Candidate> search_solution(const Recording& recording, const Constraints& constraints,
                                    const IdentifyOptions& options) {
  std::optional<Candidate> best;
  std::optional<Error> first_error;
  bool confirmed = false;
  int attempt = 0;
  const auto alignments = alignments_for(recording, constraints, arm_for(options.model, recording.arm));
  // Begun at a nominal arm that sees its features, the minimum is the right one.
  const bool starts_near = alignments.front() == Alignment::None;
  for (const Alignment alignment : alignments) {
    auto candidate = candidate_from(alignment, recording, constraints, options);
    ++attempt;
    if (!candidate) {
      if (candidate.error().code != ErrorCode::NoSolution) {
        return candidate;
      }
      first_error = first_error ? first_error : candidate.error();
      continue;
    }
    const bool near = starts_near && alignment == Alignment::None;
    if (!near || !candidate->misfits.empty()) {
      improve(*candidate, recording, constraints, options);
    }
    candidate->attempt = attempt;
    confirmed = candidate->misfits.empty() &&
                (near || as_stated(*candidate, options) || (best && confirms(*candidate, *best, options)));
    if (!best || is_better(*candidate, *best, options)) {
      best = std::move(*candidate);
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

}  // namespace artcal
