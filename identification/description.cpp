#include "identification/description.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/statistics.h"
#include "identification/identifiability/selection.h"

namespace artcal {
namespace {

ParameterState state_of(const Parameter& parameter, const Estimate& estimate, const std::vector<WristPair>& pairs) {
  const std::string& name = parameter.name;
  if (std::find(estimate.weak.begin(), estimate.weak.end(), name) != estimate.weak.end()) {
    return ParameterState::Weak;
  }
  if (find_parameter(estimate.preparation.free, name) >= 0) {
    return ParameterState::Identified;
  }
  const Coupling& coupling = estimate.preparation.coupling;
  const bool unidentifiable =
      std::any_of(coupling.unidentifiable.begin(), coupling.unidentifiable.end(),
                  [&](const ParameterMotion& motion) { return coupling.parameters[motion.leading].name == name; });
  const bool in_pair = std::any_of(pairs.begin(), pairs.end(),
                                   [&](const WristPair& pair) { return pair.first == name || pair.second == name; });
  return unidentifiable && !in_pair ? ParameterState::Unidentifiable : ParameterState::Fixed;
}

// Of u: the part that the residuals gave has theirs, the certificates' part is known (Welch, Satterthwaite).
double degrees_of_freedom_of(double u, double of_noise, int of_residuals) {
  const std::array<UncertaintyComponent, 2> components{
      {{of_noise, static_cast<double>(of_residuals)}, {std::sqrt(std::max(0.0, u * u - of_noise * of_noise))}}};
  return effective_degrees_of_freedom(components);
}

}  // namespace

std::vector<IdentifiedParameter> describe_parameters(const Arm& nominal, const Estimate& estimate,
                                                     const EstimateUncertainty& uncertainty, const Noise& noise) {
  const Eigen::MatrixXd covariance = uncertainty.covariance();
  const bool noise_is_known = noise.is_given() && uncertainty.scale_factor <= 1.0;
  const auto pairs = wrist_pairs(nominal);
  std::vector<IdentifiedParameter> all;
  for (const Parameter& parameter : all_parameters(nominal)) {
    const int free = find_parameter(estimate.preparation.free, parameter.name);
    const bool is_asked = find_parameter(estimate.preparation.coupling.parameters, parameter.name) >= 0;
    if (!is_asked &&
        (parameter.kind == ParameterKind::Radius || (parameter.is_joint_error() && value(nominal, parameter) == 0.0))) {
      continue;  // known, and no part of this
    }
    IdentifiedParameter& described =
        all.emplace_back(IdentifiedParameter{parameter, value(nominal, parameter), value(estimate.fit.arm, parameter)});
    described.state = state_of(parameter, estimate, pairs);
    if (free < 0) {
      continue;
    }
    described.u = std::sqrt(covariance(free, free));
    if (!noise_is_known) {
      described.degrees_of_freedom =
          degrees_of_freedom_of(described.u, uncertainty.scale_factor * std::sqrt(uncertainty.of_readings(free, free)),
                                estimate.fit.degrees_of_freedom);
    }
  }
  return all;
}

std::vector<ArtefactValue> describe_artefacts(const Constraints& constraints, const Estimate& estimate,
                                              const EstimateUncertainty& uncertainty) {
  const ArmFit& fit = estimate.fit;
  const auto variances = shared_variances(fit.linearisation);
  std::vector<ArtefactValue> values;
  for (std::size_t s = 0; s < constraints.shared.size() && variances; ++s) {
    const ArtefactParameter& shared = constraints.shared[s];
    const Artefact& artefact = constraints.artefacts[shared.artefact];
    const CertifiedFeature& feature = artefact.features[shared.feature];
    const auto i = static_cast<Eigen::Index>(s);
    const bool radius = shared.quantity == ArtefactParameter::Quantity::Radius;
    const double from = radius ? 0.0 : (*feature.at)[static_cast<Eigen::Index>(shared.quantity)];
    values.push_back(
        {artefact.name, feature.name, shared.quantity,
         shared.u > 0.0 ? std::optional(from + shared.certified) : std::nullopt, shared.u,
         from + fit.unknowns.shared[i],
         uncertainty.scale_factor * std::sqrt((*variances)[i] + uncertainty.of_certificates.of_shared[i])});
  }
  return values;
}

}  // namespace artcal
