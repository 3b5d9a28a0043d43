#pragma once

#include <string>
#include <vector>

#include "acquisition/recording/recording.h"
#include "artefacts/simulation/plan/plan.h"
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

/// What went into one scan: a placement, a posture and a repeat of a probing that asks for scans.
struct SimulatedScan {
  std::string file;                                ///< "scan-1.pcd", in order of appearance
  int probing = 0;                                 ///< into SimulationPlan::probings
  int placement = 0, orientation = 0, repeat = 0;  ///< into the labels of the recording
  std::vector<int> readings;                       ///< into Recording::readings, feature after feature
};

/// A recording, and all that is true of it.
struct Simulation {
  VirtualArm arm;                       ///< the true one
  std::vector<RealArtefact> artefacts;  ///< as SimulationPlan::artefacts
  std::vector<RealPlacement> placements;
  /// What a technician would have: the nominal arm, readings with their noise. The noise is stated where a
  /// recording can state it: the same for all joints, and above zero for joints and probing.
  Recording recording;
  std::vector<SimulatedScan> scans;  ///< of which readings; those are in the recording like all others
};

/// How many scans a plan makes.
int planned_scans(const SimulationPlan& plan);

/// The recording as it is written: readings of scans are not in it but what it says of its scans, whose paths are the
/// names of their files.
Recording recording_with_scans(const Simulation& simulation);

/// Takes all readings of a plan, on `threads` threads (0: as many as the machine has). The same plan gives the
/// same bits with any number of them.
///
/// Refused, with the plan's line: an artefact that nothing places, a reading that the arm does not reach, a
/// placement that was to be drawn and for which 300 draws found no place.
Expected<Simulation> simulate(const SimulationPlan& plan, int threads = 0);

}  // namespace artcal
