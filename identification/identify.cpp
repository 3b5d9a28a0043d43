#include "identification/identify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "acquisition/recording/tip_centres.h"
#include "core/statistics.h"
#include "core/text/in_quotes.h"
#include "identification/cross_validation/leave_out.h"
#include "identification/cross_validation/placement_refit.h"
#include "identification/description.h"
#include "identification/evaluation/goodness_of_fit.h"
#include "identification/evaluation/judgement.h"
#include "identification/evaluation/outliers.h"
#include "identification/evaluation/residual_diagnostics.h"
#include "identification/identifiability/parallel_axes.h"
#include "identification/initial/solution_search.h"
#include "identification/models/group_fit.h"
#include "identification/problem/preparation.h"
#include "identification/uncertainty/correlated_errors.h"
#include "identification/uncertainty/influence.h"
#include "identification/uncertainty/unmodelled_errors.h"

namespace artcal {
namespace {

Redundancy redundancy_at(const Recording& recording, const Constraints& constraints, const ArmFit& fit,
                         const std::vector<Parameter>& free) {
  System system = make_system(recording, constraints, fit.arm, free);
  system.scale = fit.scale;  // of the linearisation's columns
  return redundancy_of(system, fit.weights, fit.loss_weights, fit.linearisation, fit.arm, fit.unknowns);
}

// The readings that an arm fitted with a robust loss leaves out, if there is one that fits all others.
std::vector<std::string> strangers(const Recording& recording, const Constraints& constraints,
                                   IdentifyOptions options) {
  options.loss = Loss::Cauchy;
  const auto found = search_solution(recording, constraints, options);
  std::vector<std::string> where;
  if (found && found->misfits.empty()) {
    const Redundancy redundancy = redundancy_at(recording, constraints, found->fit, found->preparation.free);
    const Outliers outliers = find_outliers(recording, constraints, found->fit, redundancy, found->after);
    for (const CertificateOutlier& outlier : outliers.certificates) {
      where.push_back(fmt::format("the certified {} of artefact {} ({:+.3g} mm)", quantity_text(outlier),
                                  in_quotes(outlier.name.artefact), -outlier.deviation));
    }
    for (const Outlier& outlier : outliers.readings) {
      where.push_back(fmt::format("{} ({}, {}, {:+.3g} mm)", recording.where(outlier.reading), outlier.name.placement,
                                  outlier.name.feature, outlier.deviation));
    }
  }
  return where;
}

// Certificates' errors are those of the placement left out too and cancel there in part: each counts as new, here too.
UncertaintySources sources_of(const Eigen::MatrixXd& covariance, double found_noise, const std::vector<Parameter>& free,
                              const Noise& noise, double scale_factor) {
  return {free, scale_factor * scale_factor * covariance, scale_factor * noise.encoder.value_or(0.0),
          scale_factor * noise.probing.value_or(found_noise)};
}

// A few steps from the solution instead of a whole identification. Priors, robust weights and the choice of what is
// fixed are left to the latter.
RefitWithout refit_of(const System& identified, const ArmFit& fit, const Recording& recording,
                      const IdentifyOptions& options, const Identification& result) {
  if (options.loss != Loss::None || !result.weak.empty() || !result.fixed_members.empty()) {
    return {};
  }
  auto refit = PlacementRefit::of(identified, fit, recording, options.noise);
  if (!refit) {
    return {};
  }
  return [&, refit = std::move(*refit)](int artefact, int placement) -> std::optional<ArmWithout> {
    auto found = refit.without({artefact, placement});
    if (!found || !keeps_all_members(recording, identified.free, options, found->arm, found->covariance_bound)) {
      return std::nullopt;
    }
    return ArmWithout{std::move(found->arm),
                      sources_of(found->covariance, fit.noise, identified.free, options.noise, result.scale_factor)};
  };
}

// Of each u: the part that the residuals gave has theirs, the certificates' part is known (Welch, Satterthwaite).
void set_degrees_of_freedom(const Eigen::MatrixXd& of_readings, int degrees_of_freedom, Identification& result) {
  if (result.noise_is_given && result.scale_factor <= 1.0) {
    return;
  }
  for (std::size_t i = 0; i < result.free.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double noise = result.scale_factor * std::sqrt(of_readings(k, k));
    const double all = std::sqrt(result.covariance(k, k));
    const std::array<UncertaintyComponent, 2> components{
        {{noise, static_cast<double>(degrees_of_freedom)}, {std::sqrt(std::max(0.0, all * all - noise * noise))}}};
    result.parameters[result.free[i]].degrees_of_freedom = effective_degrees_of_freedom(components);
  }
}

void tell(const IdentifyOptions& options, const std::string& what) {
  if (options.progress) {
    options.progress(what, 0, 0);
  }
}

}  // namespace

double IdentifiedParameter::coverage_factor() const { return stated_coverage_factor(degrees_of_freedom); }

Expected<Identification> identify(const Recording& recording, const Constraints& constraints,
                                  const IdentifyOptions& options) {
  if (auto there = require_joints(recording); !there) {
    return tl::unexpected(there.error());
  }
  tell(options, "initial alignment and least squares");
  auto found = search_solution(recording, constraints, options);
  if (!found) {
    return tl::unexpected(with_parallel_axes(with_reason(found.error(), recording, constraints, recording.arm),
                                             recording, constraints, options));
  }
  if (!found->misfits.empty() && !options.accept_misfit) {
    return tl::unexpected(
        with_parallel_axes(misfit_error(found->misfits, found->attempt, strangers(recording, constraints, options)),
                           recording, constraints, options));
  }
  Preparation* const preparation = &found->preparation;
  const ArmFit* const fit = &found->fit;
  tell(options, "uncertainties and outliers");
  const auto covariance = arm_covariance(fit->scale, fit->linearisation);
  if (!covariance) {
    return no_solution(
        "the readings determine the parameters at the nominal arm but not at the identified one; hold "
        "the parameters that the coupling analysis calls weak");
  }
  const System identified = make_system(recording, constraints, fit->arm, preparation->free);
  const auto common = correlated_certificate_errors(identified, *fit, recording);
  if (!common) {
    return tl::unexpected(common.error());
  }
  const auto before = evaluate(recording, constraints, recording.arm);
  Identification result;
  result.arm = fit->arm;
  result.model = options.model;
  result.fixed_members = std::move(found->fixed);
  result.noise_is_given = options.noise.is_given();
  const Redundancy redundancy = redundancy_at(recording, constraints, *fit, preparation->free);
  judge_noise(*fit, goodness_of_fit(constraints, *fit, options.loss, redundancy), result);
  result.covariance = result.scale_factor * result.scale_factor * (*covariance + common->of_arm);
  result.parameters = describe(arm_for(options.model, recording.arm), fit->arm, *preparation, result.covariance);
  for (const Parameter& parameter : preparation->free) {
    const auto described_at =
        std::find_if(result.parameters.begin(), result.parameters.end(),
                     [&](const auto& described) { return described.parameter.name == parameter.name; });
    result.free.push_back(static_cast<int>(described_at - result.parameters.begin()));
  }
  if (auto sensible = check_joint_errors(result.parameters); !sensible) {
    return tl::unexpected(sensible.error());
  }
  set_degrees_of_freedom(*covariance, fit->degrees_of_freedom, result);
  result.artefact_values = describe_artefacts(constraints, *fit, *common, result.scale_factor);
  // A nominal arm so far off that nothing can be fitted to its points says nothing against the identified one.
  result.before = before ? *before : not_evaluated(found->after);
  if (!before) {
    result.warnings.push_back(
        "the nominal arm cannot be evaluated by these readings, so that there is nothing to compare "
        "the identified one with: " +
        before.error().message);
  }
  result.after = std::move(found->after);
  result.alignment = found->alignment;
  result.attempts = found->attempt;
  mark_weak(found->weak, result);
  result.misfits = std::move(found->misfits);
  Outliers outliers = find_outliers(recording, constraints, *fit, redundancy, result.after);
  result.outliers = std::move(outliers.readings);
  result.certificate_outliers = std::move(outliers.certificates);
  result.influences = influences_of(constraints, *fit, redundancy);
  if (auto warning = warning_of(result.certificate_outliers, options.loss); !warning.empty()) {
    result.warnings.push_back(std::move(warning));
  }
  tell(options, "search for unmodelled effects");
  result.model_study = search_residuals(identified, *fit, recording);
  if (auto warning = warning_of(result.model_study); !warning.empty()) {
    result.warnings.push_back(std::move(warning));
  }
  if (auto note = note_on_parallel_axes(recording, constraints, options, result.after); !note.empty()) {
    result.warnings.push_back(std::move(note));
  }
  result.iterations = fit->iterations;
  result.noise_rounds = fit->rounds;
  result.cost = fit->cost;
  result.termination = fit->termination;
  if (options.leave_out) {
    IdentifyOptions again = options;
    if (!options.noise.is_given()) {
      again.noise.reading = fit->noise;
    }
    // From the arm found: what one placement less changes is small, and the nominal arm is far.
    const auto identify_without = [&](const Constraints& rest) -> Expected<ArmWithout> {
      auto prepared = prepare_from(fit->arm, recording, rest, again);
      if (!prepared) {
        return tl::unexpected(prepared.error());
      }
      return fit_groups(recording, rest, std::move(*prepared), again, {result.weak, recording.arm})
          .map([&](const GroupFit& refit) {
            const auto covariance_without = arm_covariance(refit.fit.scale, refit.fit.linearisation);
            return ArmWithout{refit.fit.arm, sources_of(covariance_without.value_or(Eigen::MatrixXd()), refit.fit.noise,
                                                        refit.preparation.free, options.noise, result.scale_factor)};
          });
    };
    result.left_out = leave_placements_out(
        identified, recording, constraints,
        {refit_of(identified, *fit, recording, again, result), identify_without, options.threads, options.progress});
    judge_by_left_out(options.loss, result);
  }
  result.coupling = std::move(preparation->coupling);
  const auto more = suspicions(result, reach(recording.arm));
  result.warnings.insert(result.warnings.end(), more.begin(), more.end());
  return result;
}

}  // namespace artcal
