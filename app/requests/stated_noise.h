#pragma once

#include <string>

#include "core/error.h"

namespace artcal {

/// Whether there may be no noise at all.
enum class ZeroNoise { Refused, Allowed };

/// A standard deviation that an option states with its unit, in mm or rad. Usage: no number above zero (or zero, where
/// it is allowed) with a unit of the kind, with a question where a comma seems to be a decimal comma; or one that no
/// measurement has (plausible.h).
Expected<double> stated_length_noise(const std::string& text, const char* option, ZeroNoise zero = ZeroNoise::Refused);
Expected<double> stated_angle_noise(const std::string& text, const char* option, ZeroNoise zero = ZeroNoise::Refused);

}  // namespace artcal
