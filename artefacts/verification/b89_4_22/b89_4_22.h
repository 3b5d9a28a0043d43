#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// Single-point articulation of one seat: the deviations of readings of one point in many postures.
struct Articulation {
  std::string artefact, placement, feature;
  int readings = 0;
  double largest = 0.0;                                  ///< max |p − mean|, mm
  double twice_s = 0.0;                                  ///< 2·√(Σ|p − mean|²/(n − 1)), mm
  Eigen::Vector3d half_range = Eigen::Vector3d::Zero();  ///< (max − min)/2 along x, y, z of the base: FARO's figure
};

/// What all lengths of the ball bar say together, mm.
struct VolumetricSummary {
  int lengths = 0;
  double largest = 0.0;    ///< |error| at most
  double range = 0.0;      ///< largest less smallest error
  double twice_rms = 0.0;  ///< 2·√(Σe²/n), about zero
  double twice_s = 0.0;    ///< 2·√(Σ(e − mean)²/(n − 1)), about the mean
};

struct B89Verification {
  Verification verification;
  std::vector<Articulation> articulations;
  std::optional<VolumetricSummary> volumetric;
};

/// The three tests of ASME B89.4.22: effective diameter of single balls, single-point articulation of
/// artefacts that are one seat, lengths of everything with certified lengths. The formulas are as remembered;
/// docs/verification.md says so. Refused: a recording in which nothing can be evaluated.
Expected<B89Verification> verify_b89_4_22(const Session& session);

}  // namespace artcal
