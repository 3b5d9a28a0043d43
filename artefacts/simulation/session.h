#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "artefacts/simulation/plan/plan.h"
#include "artefacts/simulation/true_artefact.h"
#include "artefacts/simulation/virtual_arm.h"
#include "core/rigid.h"

namespace artcal {

/// One reading that is to be taken in a placement.
struct Job {
  int probing = 0;                                       ///< into SimulationPlan::probings
  int feature = 0;                                       ///< into Artefact::features
  int point = 0;                                         ///< of the pattern, from 0
  int orientation = 0;                                   ///< from 1; 0 where there are none
  int repeat = 0;                                        ///< from 0
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< ball: from its centre, unit, in the base frame
  Eigen::Vector2d place = Eigen::Vector2d::Zero();       ///< plane: on its rectangle, mm
};

/// All readings of one placement, in the order they are taken.
std::vector<Job> jobs_of(const SimulationPlan& plan, int placement);

/// What is really there during one reading.
struct Scene {
  const SimulationPlan& plan;
  const VirtualArm& arm;         ///< the true one
  const RealArtefact& artefact;  ///< the true one
  int placement = 0;             ///< into SimulationPlan::placements
  Rigid base_from_artefact;
};

/// What a reading gives.
struct Taken {
  Eigen::VectorXd joints;                                                    ///< rad, noise included
  double temperature = Reading::not_read;                                    ///< of the artefact, °C
  double arm_temperature = Reading::not_read;                                ///< °C
  double length = Reading::not_read;                                         ///< mm
  Eigen::Vector3d reference = Eigen::Vector3d::Constant(Reading::not_read);  ///< mm
};

/// Takes reading `index` of a placement that has `count`. It depends on the plan's seed, the placement and the
/// index alone, not on other readings. Nothing if the arm does not get there.
std::optional<Taken> take_reading(const Scene& scene, const Job& job, int index, int count);

}  // namespace artcal
