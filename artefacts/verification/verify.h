#pragma once

#include <optional>
#include <string>
#include <vector>

#include "artefacts/verification/b89_4_22/b89_4_22.h"
#include "artefacts/verification/interim.h"
#include "artefacts/verification/iso10360_12/iso10360_12.h"
#include "artefacts/verification/sphere_plate/sphere_plate.h"

namespace artcal {

enum class Standard { Iso10360_12, B89_4_22, SpherePlate };

/// A verification with what its standard tells beside the values.
struct VerificationResult {
  Verification verification;
  std::vector<PlatePlacement> plates;           ///< sphere-plate
  std::vector<PlateCalibration> calibrations;   ///< sphere-plate, from four or more placements
  std::vector<Articulation> articulations;      ///< b89.4.22
  std::optional<VolumetricSummary> volumetric;  ///< b89.4.22
  std::optional<InterimCheck> interim;          ///< where an earlier verification was given
};

/// One of verify_iso10360_12, verify_b89_4_22 and verify_sphere_plate; their errors.
Expected<VerificationResult> verify(const Session& session, Standard standard);

}  // namespace artcal
