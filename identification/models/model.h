#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "acquisition/arm/parameters.h"
#include "acquisition/recording/recording.h"
#include "core/error.h"

namespace artcal {

/// Parameters that enter a model together, beside those of Denavit and Hartenberg and the tips as the arm states
/// them. Their equations: acquisition/arm/arm.h, JointErrors.
enum class ParameterGroup {
  Eccentricity,        ///< first harmonic of each encoder's error: cos_q, sin_q
  SecondEccentricity,  ///< its second harmonic: cos_2q, sin_2q
  Gain,                ///< of each joint
  Coupling,            ///< of each joint but the first to the one before
  Gravity,             ///< compliance of each joint; needs the masses of the links
  Thermal,             ///< expansion of each link; needs the arm's temperature at each reading
  Hayati,  ///< β where neighbouring axes are parallel to 5°; every model has it there, this one demands it
  Tip,     ///< lx and ly of tips that the arm states on its last axis
  Radius,  ///< of each tip
};
inline constexpr int parameter_groups = 9;
using Model = std::vector<ParameterGroup>;

/// As `--model` writes it: eccentricity, eccentricity2, gain, coupling, gravity, thermal, hayati, tip, radius.
std::string_view name_of(ParameterGroup group);

/// "dh+eccentricity+gain".
std::string model_text(const Model& model);

/// What a person asks for.
struct ModelRequest {
  Model groups;
  bool automatic = false;  ///< groups are to be added while that is worth it (identification/models/automatic_model.h)
};

/// Reads "dh", "dh+eccentricity+gain", "auto". Usage error: anything else.
Expected<ModelRequest> model_request(std::string_view text);

/// The nominal arm of a model: with Hayati's angles where neighbouring axes are nearly parallel (with_hayati_angles()),
/// and with what the groups let it have: tips that may be off the axis.
Arm arm_for(const Model& model, Arm arm);

/// The parameters that a group adds to an arm for it (arm_for). A link shorter than a hundredth of the reach has no
/// expansion.
std::vector<Parameter> members_of(ParameterGroup group, const Arm& arm);

/// d of the joints whose β is a parameter because neighbouring axes are nearly parallel: preferred for fixing, since
/// the five parameters of the joint always have one unidentifiable direction. Not where `hold` names the joint's β:
/// that is the model of Denavit and Hartenberg alone.
std::vector<std::string> offsets_replaced_by_beta(const Arm& arm, const std::vector<std::string>& hold);

/// Why the group makes no sense for this arm and recording, whatever the readings tell; empty if it does. `arm` is
/// the arm as stated, without the group.
std::string obstacle_to(ParameterGroup group, const Arm& arm, const Recording& recording);

}  // namespace artcal
