#pragma once

#include <string>

#include "acquisition/arm/arm.h"
#include "core/error.h"

namespace artcal {

/// The arm as a URDF: a joint for each of its own, and behind the last one a fixed joint to each probe's tip. Lengths
/// in m, with every digit.
///
/// Bad input, by the joint: what a URDF cannot express, which are errors of joints (harmonics, gain, coupling,
/// compliance, expansion), a mechanical coupling, and a prismatic joint whose ends are not stated.
Expected<std::string> urdf_text(const Arm& arm);

}  // namespace artcal
