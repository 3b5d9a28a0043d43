#pragma once

#include <optional>
#include <string>

#include "acquisition/arm/arm_identification.h"
#include "acquisition/point_cloud/cloud_limits.h"
#include "acquisition/recording/tip_centres.h"
#include "artefacts/constraints/constraint.h"
#include "artefacts/verification/session.h"
#include "core/files/file_access.h"

namespace artcal {

/// What a verification is asked of beside the recording; empty: what the recording names.
struct VerificationSources {
  std::string arm, specification;
  FileAccess access;        ///< to what the recording's artefacts name
  CloudLimits limits = {};  ///< of the memory that compressed points may take
};

/// What a session refers to.
struct VerificationMaterial {
  Recording recording;
  Constraints constraints;
  std::optional<Arm> other_arm;
  std::optional<ArmIdentification> other_identification;  ///< of other_arm
  TipCentres tips;
  Specification specification;

  [[nodiscard]] Session session() const {
    const auto& known = other_arm ? other_identification : recording.arm_identification;
    const bool by_arm = tips.source == TipSource::Joints;
    return {recording, constraints,   other_arm ? *other_arm : recording.arm,
            tips,      specification, known && by_arm ? &*known : nullptr};
  }
};

/// Reads what a recording and the sources refer to, scans by the arm that is judged; notes every file as an input of
/// the recording.
Expected<VerificationMaterial> read_verification_material(Recording recording, const VerificationSources& sources);

}  // namespace artcal
