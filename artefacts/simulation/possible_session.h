#pragma once

#include "artefacts/simulation/plan/plan.h"

namespace artcal {

/// What could be read of an artefact that may stand anywhere in an arm's reach.
struct PossibleSession {
  int placements = 60;  ///< drawn at random
  int readings = 20;    ///< of each feature in each
  std::uint64_t seed = 1;
};

/// A plan without noise and without errors: `arm` is the true arm as well, within the end stops that it states. Balls
/// are touched on their upper half; placements are called "1", "2" and so on.
SimulationPlan possible_session(const Arm& arm, const Artefact& artefact, const PossibleSession& session = {});

}  // namespace artcal
