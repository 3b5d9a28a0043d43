#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/stream/planted_mistake.h"
#include "artefacts/simulation/simulate.h"
#include "core/error.h"

namespace artcal {

/// The events that a virtual arm sends, as examples/streams/simulated.toml reads them: an object a line with Angle1 …
/// (deg; mm of prismatic joints), X, Y, Z (mm, as the nominal arm has them), Buttons, ArmAtRest, EncodersReferenced,
/// EndStops, TimeStamp (s). Two events a reading, the button pressed and released, `period` apart from reading to
/// reading; and before the first reading of each feature what a person says (!artefact, !placement, !feature).
/// `send` takes a reading's lines; false ends the stream.
/// Refused: a plan with scans.
Expected<void> send_events(const Simulation& simulation, const std::vector<PlantedMistake>& mistakes, double period,
                           const std::function<bool(const std::string&)>& send);

}  // namespace artcal
