#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "artefacts/simulation/simulate.h"
#include "identification/planning/planning.h"

namespace artcal {

/// What `artcal plan` found, and from what.
struct PlanResult {
  const SimulationPlan& plan;
  const Simulation& possible;
  const Planning& planning;
  const PlanningOptions& options;
  std::vector<InputFile> inputs;
  int measured_readings = 0;
};

/// Ends of an artefact as it would stand, mm: the centres of its first and last feature.
struct StandingEnds {
  Eigen::Vector3d first_in_base;
  Eigen::Vector3d last_in_base;
};
StandingEnds ends_of(const Simulation& possible, int candidate);

nlohmann::ordered_json to_json(const PlanResult& result);
std::string to_text(const PlanResult& result);
/// One row for each reading to take: placement, feature, joint angles in degrees, and the pose of the artefact there.
std::string to_csv(const PlanResult& result);
/// Plan and elevation of the arm's reach with all possible placements and the chosen ones, as SVG.
std::string to_picture(const PlanResult& result);

}  // namespace artcal
