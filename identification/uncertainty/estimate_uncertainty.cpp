#include "identification/uncertainty/estimate_uncertainty.h"

#include <algorithm>
#include <utility>

#include "identification/uncertainty/covariance.h"

namespace artcal {
namespace {

// Only a stated noise can be exceeded; an estimated one is the residuals'.
double scale_factor_of(const GoodnessOfFit& goodness_of_fit, const Noise& noise) {
  const bool exceeded = noise.is_given() && goodness_of_fit.chi_squared > goodness_of_fit.high;
  return exceeded ? std::max(1.0, goodness_of_fit.ratio) : 1.0;
}

}  // namespace

Expected<EstimateUncertainty> uncertainty_of(const System& system, const Estimate& estimate, const Recording& recording,
                                             const IdentifyOptions& options) {
  const ArmFit& fit = estimate.fit;
  auto of_readings = arm_covariance(fit.scale, fit.linearisation);
  if (!of_readings) {
    return no_solution(
        "the readings determine the parameters at the nominal arm but not at the identified one; fix the parameters "
        "that the coupling analysis calls weak (--hold)");
  }
  auto of_certificates = correlated_certificate_errors(system, fit, recording);
  if (!of_certificates) {
    return tl::unexpected(of_certificates.error());
  }
  const Constraints& constraints = *system.constraints;
  EstimateUncertainty uncertainty;
  uncertainty.of_readings = std::move(*of_readings);
  uncertainty.of_certificates = std::move(*of_certificates);
  uncertainty.redundancy = redundancy_of(recording, constraints, fit, estimate.preparation.free);
  uncertainty.goodness_of_fit = goodness_of_fit(constraints, fit, options.loss, uncertainty.redundancy);
  uncertainty.scale_factor = scale_factor_of(uncertainty.goodness_of_fit, options.noise);
  return uncertainty;
}

}  // namespace artcal
