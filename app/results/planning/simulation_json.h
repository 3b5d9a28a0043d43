#pragma once

#include <nlohmann/json.hpp>

#include "artefacts/simulation/plan/plan_file.h"
#include "artefacts/simulation/simulate.h"

namespace artcal {

/// What is true of a simulated recording. Schema: docs/result-schema.md, "simulation".
nlohmann::ordered_json to_json(const PlanFile& file, const Simulation& simulation);

}  // namespace artcal
