#pragma once

#include "artefacts/simulation/simulate.h"

namespace artcal {

/// Adds the recording's last reading, of that probing, to the scan that it belongs to, which may be a new one.
void add_to_scan(Simulation& simulation, int probing);

}  // namespace artcal
