#include "app/results/identification/identification_run.h"

#include "app/output/phrases.h"
#include "identification/models/automatic_model.h"

namespace artcal {

Loss loss_named(const std::string& name) {
  return name == "huber" ? Loss::Huber : name == "cauchy" ? Loss::Cauchy : Loss::None;
}

IdentifyOptions recorded_options(const Recording& recording) {
  IdentifyOptions options;
  options.hold = recording.identify.hold;
  options.free = recording.identify.free;
  options.loss = loss_named(recording.identify.loss);
  options.noise = recording.noise;
  return options;
}

Expected<Identification> run_identification(const Recording& recording, const Constraints& constraints,
                                            const IdentifyOptions& options) {
  auto result = options.automatic ? identify_automatically(recording, constraints, options)
                                  : identify(recording, constraints, options);
  if (result) {
    auto& warnings = result->warnings;
    for (const std::string& reason : result->misfits) {
      warnings.insert(warnings.begin(), "this arm is no solution of its readings (--accept-misfit): " + reason);
    }
    warnings.insert(warnings.begin(), constraints.warnings.begin(), constraints.warnings.end());
    warnings.insert(warnings.begin(), recording.warnings.begin(), recording.warnings.end());
    return result;
  }
  return tl::unexpected(with_warnings(result.error(), recording.warnings));
}

}  // namespace artcal
