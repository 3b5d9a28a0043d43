#pragma once

#include "artefacts/simulation/plan/plan.h"
#include "core/toml/toml_document.h"

namespace artcal {

/// The tables of a plan that say how the true arm differs from the nominal one. `angle` is the plan's unit.
/// Whatever is wrong is noted in the tables.
ArmErrors read_arm_errors(TomlTable table, const Arm& true_arm);
PlannedNoise read_planned_noise(TomlTable& table);

/// Reads the tables [[joint]] into the arm's joints, whose encoder noise is `encoder_noise` unless a joint
/// states its own.
void read_virtual_joints(TomlTable& root, VirtualArm& arm, double angle, double encoder_noise);

/// Notes where the true arm is another kind of arm than the nominal one.
void check_same_kind(TomlTable& root, const Arm& nominal, const Arm& real);

/// A joint without errors and with the travel that the arm's file states; a whole turn from the one end where the other
/// is not stated. `encoder_noise` in rad.
VirtualJoint plain_joint(const Joint& real, double encoder_noise);

}  // namespace artcal
