#pragma once

#include <vector>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"

namespace artcal {

/// Leaves out readings that repeat an earlier one on the same feature in every joint angle (to 1e-9 rad) and measured
/// number, whatever placement, orientation, repeat and temperature they are labelled with: they are one measurement,
/// and counted as several they would make uncertainties too small and tests look complete. A warning, which is
/// Recording::repeated_readings too, says how many and where the first is.
///
/// Coordinates without joint angles in a seat may agree by the resolution they are written with; they count as repeated
/// where more than a quarter of the seat's readings do.
void drop_coincident_readings(Recording& recording, const std::vector<Artefact>& artefacts);

}  // namespace artcal
