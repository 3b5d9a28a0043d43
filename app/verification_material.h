#pragma once

#include <optional>
#include <string>

#include "acquisition/tip_centres.h"
#include "artefacts/constraint.h"
#include "artefacts/verification/session.h"

namespace artcal {

/// The files that a verification is asked of. The arm and the specification may be empty: those of the recording.
struct VerificationSources {
  std::string recording, arm, specification;
};

/// What a session refers to.
struct VerificationMaterial {
  Recording recording;
  Constraints constraints;
  std::optional<Arm> other_arm;
  TipCentres tips;
  Specification specification;

  [[nodiscard]] Session session() const {
    return {recording, constraints, other_arm ? *other_arm : recording.arm, tips, specification};
  }
};

/// Reads them all, scans by the arm that is judged; notes every file as an input of the recording.
Expected<VerificationMaterial> read_verification_material(const VerificationSources& sources);

}  // namespace artcal
