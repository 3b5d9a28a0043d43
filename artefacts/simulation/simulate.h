#pragma once

#include <string>
#include <vector>

#include "acquisition/recording.h"
#include "artefacts/simulation/plan.h"
#include "artefacts/simulation/true_artefact.h"
#include "core/error.h"

namespace artcal {

/// Where an artefact really stood.
struct RealPlacement {
  std::string name;
  int artefact = 0;  ///< into SimulationPlan::artefacts
  Rigid base_from_artefact;
  double temperature = 20.0;  ///< of the artefact at the first reading, °C
  double temperature_end = 20.0;
  int readings = 0;
};

/// A recording, and all that is true of it.
struct Simulation {
  VirtualArm arm;                       ///< the true one
  std::vector<RealArtefact> artefacts;  ///< as SimulationPlan::artefacts
  std::vector<RealPlacement> placements;
  /// What a technician would have: the nominal arm, readings with their noise. The noise is stated where a
  /// recording can state it: the same for all joints, and above zero for joints and probing.
  Recording recording;
};

/// Takes all readings of a plan, on `threads` threads (0: as many as the machine has). The same plan gives the
/// same bits with any number of them.
///
/// Refused, with the plan's line: an artefact that nothing places, a reading that the arm does not reach, a
/// placement that was to be drawn and for which 300 draws found no place.
Expected<Simulation> simulate(const SimulationPlan& plan, int threads = 0);

}  // namespace artcal
