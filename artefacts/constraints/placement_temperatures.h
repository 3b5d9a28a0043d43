#pragma once

#include <map>
#include <utility>
#include <vector>

#include "artefacts/constraints/constraint.h"

namespace artcal {

/// °C, by artefact (into the artefacts) and placement (into Recording::placements).
using PlacementTemperatures = std::map<std::pair<int, int>, double>;

/// Mean temperature of an artefact's readings in a placement; the reference where none was read. `artefact_of` says
/// of each reading which artefact it is on.
PlacementTemperatures placement_temperatures(const Recording& recording, const std::vector<int>& artefact_of,
                                             const std::vector<Artefact>& artefacts);

/// Adds a warning for each artefact that was used away from its reference temperature and states no expansion.
void warn_of_temperatures(Constraints& constraints, const PlacementTemperatures& temperatures);

}  // namespace artcal
