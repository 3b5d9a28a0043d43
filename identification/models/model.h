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
  Hayati,              ///< β where neighbouring axes are parallel to 5°; there d of the joint is held
  Tip,                 ///< lx and ly of tips that the arm states on its last axis
  Radius,              ///< of each tip
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

/// The arm with what the groups let it have: β of zero, tips that may be off the axis.
Arm arm_for(const Model& model, Arm arm);

/// The parameters that a group adds to an arm for it (arm_for). A link shorter than a hundredth of the reach has no
/// expansion.
std::vector<Parameter> members_of(ParameterGroup group, const Arm& arm);

/// Parameters that go out because the group comes in: d of the joints that Hayati's β is given to.
std::vector<std::string> fixed_with(ParameterGroup group, const Arm& arm);

/// Why the group makes no sense for this arm and recording, whatever the readings tell; empty if it does. `arm` is
/// the arm as stated, without the group.
std::string obstacle_to(ParameterGroup group, const Arm& arm, const Recording& recording);

}  // namespace artcal
