#pragma once

#include <string>
#include <vector>

#include "artefacts/verification/session.h"
#include "artefacts/verification/sphere_plate/pattern_match.h"
#include "artefacts/verification/sphere_plate/swing_round.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// What is left of one ball after the certified pattern was laid over the measured centres.
struct BallResidual {
  std::string feature;
  Eigen::Vector3d residual_in_plate = Eigen::Vector3d::Zero();  ///< measured less certified, mm
  /// Distance from where the pose of all the others foretells it, in standard deviations by their scatter
  /// (Hotelling's T; the same in all directions where there are fewer than nine balls).
  double standardised = 0.0;
  bool is_outlier = false;
};

/// One placement (and repeat) of a plate.
struct PlatePlacement {
  std::string artefact, placement, repeat;
  double temperature = 0.0;  ///< °C; NaN where it was not read
  std::vector<BallResidual> balls;
  double rms = 0.0;                       ///< of the residual vectors' lengths, mm
  double limit = 0.0;                     ///< of BallResidual::standardised
  double scale = 0.0;                     ///< measured over certified, less one
  double u_scale = 0.0;                   ///< standard uncertainty: scatter, certificate, temperature
  double k_scale = 2.0;                   ///< coverage factor by its effective degrees of freedom
  double en_worst = 0.0;                  ///< largest |En| of its distances
  std::vector<std::string> not_measured;  ///< certified balls without readings
  std::string finding;                    ///< what is wrong with the names or the poses; empty: nothing
};

struct PlateVerification {
  Verification verification;
  std::vector<PlatePlacement> placements;
  std::vector<PlateCalibration> calibrations;  ///< of plates read completely in four or more placements
};

/// A sphere plate, or any artefact with three or more certified centres not on one line: each placement is
/// fitted by a rigid motion without scale, its residuals, its scale and all N(N − 1)/2 distances as E_Uni are
/// told. Other orders of the balls, mirror images and two poses under one name are looked for. Refused: a
/// recording without such an artefact.
///     En = E/√(U² + U_ref²), with U = 2·√2·s, s the scatter of a coordinate in the pose's residuals.
Expected<PlateVerification> verify_sphere_plate(const Session& session);

}  // namespace artcal
