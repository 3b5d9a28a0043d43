#include "app/results/identification/identified_arm.h"

#include <fmt/format.h>

#include "acquisition/arm/parameters.h"
#include "acquisition/recording/reading_fingerprint.h"
#include "app/version.h"

namespace artcal {

ArmIdentification arm_identification(const Recording& recording, const IdentifyOptions& options,
                                     const Identification& result) {
  ArmIdentification known;
  known.program = fmt::format("artcal {}", program_version);
  known.recording = recording.inputs.front().sha256;
  for (const int index : result.free) {
    known.parameters.push_back(result.parameters[static_cast<std::size_t>(index)].parameter.name);
  }
  known.covariance = result.covariance;
  known.noise = result.noise * result.scale_factor;
  if (options.noise.encoder && options.noise.probing) {
    known.encoder_noise = *options.noise.encoder * result.scale_factor;
    known.probing_noise = *options.noise.probing * result.scale_factor;
  }
  known.misfits = result.misfits;
  known.unmodelled = result.cross_validation.scale;
  // What was fixed rests on the readings that the arm it started from was identified from.
  const auto& before = recording.arm_identification;
  known.readings = fingerprints_of(recording, before ? before->readings : std::vector<std::string>{});
  return known;
}

UncertaintySources uncertainty_sources(const Arm& arm, const ArmIdentification& known) {
  UncertaintySources sources;
  const auto all = all_parameters(arm);
  for (const auto& name : known.parameters) {
    sources.parameters.push_back(all[static_cast<std::size_t>(find_parameter(all, name))]);
  }
  sources.covariance = known.covariance;
  sources.encoder = known.encoder_noise.value_or(0.0);
  sources.probing = known.probing_noise.value_or(known.noise.value_or(0.0));
  return sources;
}

}  // namespace artcal
