#include "artefacts/verification/verify.h"

namespace artcal {
namespace {

VerificationResult with_articulations(B89Verification&& found) {
  VerificationResult result;
  result.verification = std::move(found.verification);
  result.articulations = std::move(found.articulations);
  result.volumetric = found.volumetric;
  return result;
}

VerificationResult with_plates(PlateVerification&& found) {
  VerificationResult result;
  result.verification = std::move(found.verification);
  result.plates = std::move(found.placements);
  result.calibrations = std::move(found.calibrations);
  return result;
}

}  // namespace

Expected<VerificationResult> verify(const Session& session, Standard standard) {
  switch (standard) {
    case Standard::B89_4_22: return verify_b89_4_22(session).map(with_articulations);
    case Standard::SpherePlate: return verify_sphere_plate(session).map(with_plates);
    case Standard::Iso10360_12: break;
  }
  return verify_iso10360_12(session).map([](Verification&& found) {
    VerificationResult result;
    result.verification = std::move(found);
    return result;
  });
}

}  // namespace artcal
