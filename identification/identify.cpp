#include "identification/identify.h"

#include <algorithm>
#include <utility>

#include "acquisition/recording/tip_centres.h"
#include "core/statistics.h"
#include "identification/cross_validation/cross_validation.h"
#include "identification/description.h"
#include "identification/estimation.h"
#include "identification/evaluation/diagnostics.h"
#include "identification/evaluation/judgement.h"
#include "identification/models/automatic_model.h"
#include "identification/uncertainty/estimate_uncertainty.h"
#include "identification/uncertainty/unmodelled_errors.h"

namespace artcal {
namespace {

void begin(const std::string& stage, const IdentifyOptions& options) {
  if (options.progress) {
    options.progress(stage, 0, 0);
  }
}

std::vector<int> positions(const std::vector<Parameter>& free, const std::vector<IdentifiedParameter>& all) {
  std::vector<int> found;
  for (const Parameter& parameter : free) {
    const auto at = std::find_if(all.begin(), all.end(), [&](const IdentifiedParameter& described) {
      return described.parameter.name == parameter.name;
    });
    found.push_back(static_cast<int>(at - all.begin()));
  }
  return found;
}

Identification described(const Constraints& constraints, const Estimate& estimate,
                         const EstimateUncertainty& uncertainty, const Recording& recording,
                         const IdentifyOptions& options) {
  const ArmFit& fit = estimate.fit;
  Identification result;
  result.arm = fit.arm;
  result.model = options.model;
  result.alignment = estimate.alignment;
  result.attempts = estimate.attempt;
  result.misfits = estimate.misfits;
  result.weak = estimate.weak;
  result.fixed_members = estimate.fixed;
  result.coupling = estimate.preparation.coupling;
  result.covariance = uncertainty.covariance();
  result.parameters = describe_parameters(arm_for(options.model, recording.arm), estimate, uncertainty, options.noise);
  result.free = positions(estimate.preparation.free, result.parameters);
  result.artefact_values = describe_artefacts(constraints, estimate, uncertainty);
  result.noise_is_given = options.noise.is_given();
  result.noise = fit.noise;
  result.chi_squared = uncertainty.goodness_of_fit.chi_squared;
  result.degrees_of_freedom = uncertainty.goodness_of_fit.degrees_of_freedom;
  result.chi_squared_low = uncertainty.goodness_of_fit.low;
  result.chi_squared_high = uncertainty.goodness_of_fit.high;
  result.scale_factor = uncertainty.scale_factor;
  result.iterations = fit.iterations;
  result.noise_rounds = fit.rounds;
  result.cost = fit.cost;
  result.termination = fit.termination;
  if (auto warning = warning_of(uncertainty.goodness_of_fit, uncertainty.scale_factor, options.noise);
      !warning.empty()) {
    result.warnings.push_back(std::move(warning));
  }
  return result;
}

void add(Diagnostics&& diagnostics, const Estimate& estimate, Identification& result) {
  result.before = std::move(diagnostics.before);
  result.after = estimate.after;
  result.outliers = std::move(diagnostics.outliers.readings);
  result.certificate_outliers = std::move(diagnostics.outliers.certificates);
  result.influences = std::move(diagnostics.influences);
  result.model_study = std::move(diagnostics.residuals);
  result.warnings.insert(result.warnings.end(), diagnostics.warnings.begin(), diagnostics.warnings.end());
}

}  // namespace

double IdentifiedParameter::coverage_factor() const { return stated_coverage_factor(degrees_of_freedom); }

Expected<Identification> identify(const Recording& recording, const Constraints& constraints,
                                  const IdentifyOptions& options) {
  if (options.automatic) {
    return identify_automatically(recording, constraints, options);
  }
  if (auto there = require_joints(recording); !there) {
    return tl::unexpected(there.error());
  }
  begin("initial alignment and least squares", options);
  const auto estimate = find_estimate(recording, constraints, options);
  if (!estimate) {
    return tl::unexpected(estimate.error());
  }
  begin("uncertainties and outliers", options);
  const System system = make_system(recording, constraints, estimate->fit.arm, estimate->preparation.free);
  const auto uncertainty = uncertainty_of(system, *estimate, recording, options);
  if (!uncertainty) {
    return tl::unexpected(uncertainty.error());
  }
  Identification result = described(constraints, *estimate, *uncertainty, recording, options);
  if (auto plausible = check_joint_errors(result.parameters); !plausible) {
    return tl::unexpected(plausible.error());
  }
  add(diagnose(system, *estimate, *uncertainty, recording, options), *estimate, result);
  if (options.leave_out) {
    result.left_out = evaluate_left_out(system, *estimate, recording, options, uncertainty->scale_factor);
    judge_by_left_out(options.loss, result);
  }
  if (!warning_of(result.model_study).empty() && result.cross_validation.scale <= 1.0) {
    result.warnings.push_back("the standard uncertainties do not include these unmodelled effects");
  }
  const auto more = suspicions(result, reach(recording.arm));
  result.warnings.insert(result.warnings.end(), more.begin(), more.end());
  return result;
}

}  // namespace artcal
