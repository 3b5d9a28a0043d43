#pragma once

#include "artefacts/simulation/plan/plan.h"

namespace artcal {

/// The plan's arm with the errors that are to be drawn on top: every structural parameter, tip radius
/// and joint error and both parts of every harmonic by a normal deviate of its own, so that no other choice in the plan
/// changes it.
VirtualArm drawn_arm(const SimulationPlan& plan);

}  // namespace artcal
