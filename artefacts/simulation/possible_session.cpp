#include "artefacts/simulation/possible_session.h"

#include <numeric>

#include <fmt/format.h>

#include "artefacts/simulation/plan/plan_arm.h"

namespace artcal {

SimulationPlan possible_session(const Arm& arm, const Artefact& artefact, const PossibleSession& session) {
  SimulationPlan plan;
  plan.name = "what could be read";
  plan.nominal = arm;
  plan.arm.arm = arm;
  for (const Joint& joint : arm.joints) {
    plan.arm.joints.push_back(plain_joint(joint, 0.0));
  }
  plan.artefacts.push_back({artefact, std::vector<TrueFeature>(artefact.features.size())});
  plan.seed = session.seed;
  PlannedProbing probing;
  probing.points = session.readings;
  probing.features.resize(artefact.features.size());
  std::iota(probing.features.begin(), probing.features.end(), 0);
  for (int i = 0; i < session.placements; ++i) {
    PlannedPlacement placement;
    placement.name = fmt::format("{}", i + 1);
    placement.where = fmt::format("placement {}", i + 1);
    plan.placements.push_back(placement);
    probing.placements.push_back(i);
  }
  plan.probings.push_back(probing);
  return plan;
}

}  // namespace artcal
