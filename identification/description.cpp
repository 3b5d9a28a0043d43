#include "identification/description.h"

#include <algorithm>
#include <cmath>

#include "identification/identifiability/selection.h"

namespace artcal {

std::vector<IdentifiedParameter> describe(const Arm& nominal, const Arm& identified, const Preparation& preparation,
                                          const Eigen::MatrixXd& covariance) {
  std::vector<IdentifiedParameter> all;
  const auto is_unidentifiable = [&](const std::string& name) {
    return std::any_of(
        preparation.coupling.unidentifiable.begin(), preparation.coupling.unidentifiable.end(),
        [&](const ParameterMotion& motion) { return preparation.coupling.parameters[motion.leading].name == name; });
  };
  const auto pairs = wrist_pairs(nominal);
  const auto in_pair = [&](const std::string& name) {
    return std::any_of(pairs.begin(), pairs.end(),
                       [&](const WristPair& pair) { return pair.first == name || pair.second == name; });
  };
  for (const Parameter& parameter : all_parameters(nominal)) {
    const int free = find_parameter(preparation.free, parameter.name);
    const bool is_asked = find_parameter(preparation.coupling.parameters, parameter.name) >= 0;
    if (!is_asked &&
        (parameter.kind == ParameterKind::Radius || (parameter.is_joint_error() && value(nominal, parameter) == 0.0))) {
      continue;  // known, and no part of this
    }
    const ParameterState state = free >= 0 ? ParameterState::Identified
                                 : is_unidentifiable(parameter.name) && !in_pair(parameter.name)
                                     ? ParameterState::Unidentifiable
                                     : ParameterState::Fixed;
    all.push_back({parameter, value(nominal, parameter), value(identified, parameter),
                   free >= 0 ? std::sqrt(covariance(free, free)) : 0.0, state});
  }
  return all;
}

std::vector<ArtefactValue> describe_artefacts(const Constraints& constraints, const ArmFit& fit,
                                              const CommonErrors& common, double scale_factor) {
  const auto variances = shared_variances(fit.linearisation);
  std::vector<ArtefactValue> values;
  for (std::size_t s = 0; s < constraints.shared.size() && variances; ++s) {
    const ArtefactParameter& shared = constraints.shared[s];
    const Artefact& artefact = constraints.artefacts[shared.artefact];
    const CertifiedFeature& feature = artefact.features[shared.feature];
    const auto i = static_cast<Eigen::Index>(s);
    const bool radius = shared.quantity == ArtefactParameter::Quantity::Radius;
    const double from = radius ? 0.0 : (*feature.at)[static_cast<Eigen::Index>(shared.quantity)];
    values.push_back({artefact.name, feature.name, shared.quantity,
                      shared.u > 0.0 ? std::optional(from + shared.certified) : std::nullopt, shared.u,
                      from + fit.unknowns.shared[i], scale_factor * std::sqrt((*variances)[i] + common.of_shared[i])});
  }
  return values;
}

}  // namespace artcal
