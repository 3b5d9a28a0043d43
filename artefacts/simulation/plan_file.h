#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "artefacts/simulation/plan.h"
#include "core/error.h"
#include "core/input_file.h"

namespace artcal {

/// A plan with the files it rests on.
struct PlanFile {
  SimulationPlan plan;
  std::filesystem::path arm;                     ///< of the nominal arm
  std::vector<std::filesystem::path> artefacts;  ///< as SimulationPlan::artefacts
  std::vector<InputFile> inputs;                 ///< the plan first
};

/// Reads plan.toml, the arms and the artefacts it names; paths are taken from the plan's own folder. Format:
/// docs/files.md, "plan.toml". Refused beside what all files refuse: true and nominal arms that differ in more
/// than their numbers, a negative noise, stops without room between them, names that nothing has, a placement
/// that nothing probes, a plan without readings or with more than most_planned_readings.
Expected<PlanFile> read_plan_file(const std::filesystem::path& path);

}  // namespace artcal
