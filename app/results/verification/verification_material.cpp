#include "app/results/verification/verification_material.h"

#include "acquisition/arm/arm_file.h"
#include "artefacts/constraints/bound_recording.h"
#include "artefacts/scans/scan_readings.h"
#include "artefacts/verification/decision/specification_file.h"

namespace artcal {
namespace {

Expected<void> read_other_arm(const std::string& path, VerificationMaterial& material) {
  if (path.empty()) {
    return {};
  }
  auto file = read_arm_file(path);
  if (!file) {
    return tl::unexpected(file.error());
  }
  material.recording.inputs.push_back(file->input);
  material.other_arm = std::move(file->arm);
  material.other_identification = std::move(file->identification);
  return {};
}

Expected<void> read_artefacts_and_tips(const VerificationSources& sources, VerificationMaterial& material) {
  const Arm* other = material.other_arm ? &*material.other_arm : nullptr;
  auto bound = bind_recording(std::move(material.recording), sources.access,
                              {ScanUse::WholeBalls, other, sources.limits.max_memory});
  if (!bound) {
    return tl::unexpected(bound.error());
  }
  material.recording = std::move(bound->recording);
  material.constraints = std::move(bound->constraints);
  const auto& known = material.other_identification;
  auto tips = other != nullptr ? tip_centres(material.recording, *other, known ? &*known : nullptr)
                               : tip_centres(material.recording);
  if (!tips) {
    return tl::unexpected(with_warnings(tips.error(), material.recording.warnings));
  }
  material.tips = std::move(*tips);
  return {};
}

Expected<void> read_specification(const std::string& named, VerificationMaterial& material) {
  const std::string& path = named.empty() ? material.recording.specification_path : named;
  if (path.empty()) {
    return {};
  }
  auto file = read_specification_file(path);
  if (!file) {
    return tl::unexpected(file.error());
  }
  material.recording.inputs.push_back(file->input);
  material.specification = std::move(file->specification);
  return {};
}

}  // namespace

Expected<VerificationMaterial> read_verification_material(Recording recording, const VerificationSources& sources) {
  VerificationMaterial material{std::move(recording), {}, {}, {}, {}, {}};
  if (auto read = read_other_arm(sources.arm, material); !read) {
    return tl::unexpected(read.error());
  }
  if (auto read = read_artefacts_and_tips(sources, material); !read) {
    return tl::unexpected(read.error());
  }
  if (auto read = read_specification(sources.specification, material); !read) {
    return tl::unexpected(read.error());
  }
  return material;
}

}  // namespace artcal
