#pragma once

#include "artefacts/simulation/plan/plan.h"
#include "core/toml/toml_document.h"

namespace artcal {

/// Units of a plan's bare numbers, to mm and rad.
struct PlanUnits {
  double length = 1.0;
  double angle = 1.0;
};

/// The tables of a plan that say what stands where and what is probed; they go into `plan`, whose arms and
/// artefacts are known. Whatever is wrong is noted in the tables.
void read_true_features(TomlTable& root, SimulationPlan& plan, const PlanUnits& units);
/// `[stand]`.
void read_stand(TomlTable& root, SimulationPlan& plan, const PlanUnits& units);
void read_placements(TomlTable& root, SimulationPlan& plan, const PlanUnits& units);
void read_probings(TomlTable& root, SimulationPlan& plan, const PlanUnits& units);

}  // namespace artcal
