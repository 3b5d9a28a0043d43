#pragma once

#include <vector>

#include <Eigen/Core>

#include "artefacts/simulation/plan/plan.h"
#include "core/error.h"
#include "core/random.h"

namespace artcal {

/// What one feature really is, in the artefact's frame at the reference temperature, mm.
struct RealFeature {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< planes, unit
  double radius = 0.0;                                ///< spheres
};

/// What an artefact really is.
struct RealArtefact {
  std::vector<RealFeature> features;  ///< as Artefact::features
  double expansion = 0.0;             ///< 1/K
};

/// Takes what is stated as true, then what is certified, then what follows from that: features with
/// certified distances and no places lie along x from the first of them, a feature alone in the origin, a
/// plane without a normal level. With `errors` whatever comes from the certificate (places, diameters,
/// distances, expansion) differs from it by a normal draw of its standard uncertainty.
///
/// Refused: features that nothing places, distances that do not fit on one line, stated places that
/// contradict certified distances by more than 4 u, a ball of which nobody states the diameter.
Expected<RealArtefact> real_artefact(const PlannedArtefact& planned, RandomStream* errors);

}  // namespace artcal
