#include "identification/cross_validation/cross_validation.h"

#include <utility>

#include "identification/cross_validation/placement_refit.h"
#include "identification/models/group_fit.h"

namespace artcal {
namespace {

// Certificates' errors are those of the placement left out too and cancel there in part: each counts as new, here too.
UncertaintySources sources_of(const Eigen::MatrixXd& covariance, double found_noise, const std::vector<Parameter>& free,
                              const Noise& noise, double scale_factor) {
  return {free, scale_factor * scale_factor * covariance, scale_factor * noise.encoder.value_or(0.0),
          scale_factor * noise.probing.value_or(found_noise)};
}

// The noise of the estimate counts as known for the identifications without a placement.
IdentifyOptions with_known_noise(IdentifyOptions options, const ArmFit& fit) {
  if (!options.noise.is_given()) {
    options.noise.reading = fit.noise;
  }
  return options;
}

// Priors, robust weights and the choice of what is fixed are left to a whole identification.
RefitWithout refit_from(const System& system, const Estimate& estimate, const Recording& recording,
                        const IdentifyOptions& with_noise, const Noise& noise, double scale_factor) {
  const ArmFit& fit = estimate.fit;
  if (with_noise.loss != Loss::None || !estimate.weak.empty() || !estimate.fixed.empty()) {
    return {};
  }
  auto refit = PlacementRefit::of(system, fit, recording, with_noise.noise, with_noise.threads);
  if (!refit) {
    return {};
  }
  return [&, noise, scale_factor, refit = std::move(*refit)](int artefact, int placement) -> std::optional<ArmWithout> {
    auto found = refit.without({artefact, placement});
    if (!found || !keeps_all_members(recording, system.free, with_noise, found->arm, found->covariance_bound)) {
      return std::nullopt;
    }
    return ArmWithout{std::move(found->arm),
                      sources_of(found->covariance, fit.noise, system.free, noise, scale_factor)};
  };
}

// From the arm found: what one placement less changes is small, and the nominal arm is far.
Expected<ArmWithout> identify_from(const Estimate& estimate, const Recording& recording, const Constraints& rest,
                                   const IdentifyOptions& with_noise, const Noise& noise, double scale_factor) {
  auto prepared = prepare_from(estimate.fit.arm, recording, rest, with_noise);
  if (!prepared) {
    return tl::unexpected(prepared.error());
  }
  const WeakPrior prior{estimate.weak, arm_for(with_noise.model, recording.arm)};
  auto fit = fit_arm(recording, rest, prepared->start, prepared->free, with_noise.noise,
                     SolveOptions{with_noise.loss, with_noise.max_iterations}, prior);
  return fix_undetermined_members(std::move(fit), recording, rest, std::move(*prepared), with_noise, prior)
      .map([&](const GroupFit& refit) {
        const auto covariance = arm_covariance(refit.fit.scale, refit.fit.linearisation);
        return ArmWithout{refit.fit.arm, sources_of(covariance.value_or(Eigen::MatrixXd()), refit.fit.noise,
                                                    refit.preparation.free, noise, scale_factor)};
      });
}

}  // namespace

std::vector<LeftOut> evaluate_left_out(const System& system, const Estimate& estimate, const Recording& recording,
                                       const IdentifyOptions& options, double scale_factor) {
  const IdentifyOptions with_noise = with_known_noise(options, estimate.fit);
  const IdentifyWithout identify = [&](const Constraints& rest) {
    return identify_from(estimate, recording, rest, with_noise, options.noise, scale_factor);
  };
  return leave_placements_out(system, recording, *system.constraints,
                              {refit_from(system, estimate, recording, with_noise, options.noise, scale_factor),
                               identify, options.threads, options.progress});
}

}  // namespace artcal
