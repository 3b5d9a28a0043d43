#include "identification/models/tried_model.h"

#include <utility>

#include "identification/cross_validation/cross_validation.h"
#include "identification/description.h"
#include "identification/evaluation/judgement.h"

namespace artcal {
Expected<TriedModel> try_model(const Recording& recording, const Constraints& constraints,
                               const IdentifyOptions& options) {
  auto estimate = search_solution(recording, constraints, options);
  if (!estimate) {
    return tl::unexpected(with_reason(estimate.error(), recording, constraints, recording.arm));
  }
  const System system = make_system(recording, constraints, estimate->fit.arm, estimate->preparation.free);
  const auto uncertainty = uncertainty_of(system, *estimate, recording, options);
  if (!uncertainty) {
    return tl::unexpected(uncertainty.error());
  }
  const Arm nominal = arm_for(options.model, recording.arm);
  if (auto plausible = check_joint_errors(describe_parameters(nominal, *estimate, *uncertainty, options.noise));
      !plausible) {
    return tl::unexpected(plausible.error());
  }
  auto left_out = evaluate_left_out(system, *estimate, recording, options, uncertainty->scale_factor);
  return TriedModel{std::move(*estimate), std::move(left_out)};
}

}  // namespace artcal
