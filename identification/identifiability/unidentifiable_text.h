#pragma once

#include <string>

#include "identification/identifiability/coupling.h"

namespace artcal {

/// An unidentifiable motion as the movement nobody sees: "a6 + 1, theta6 - 0.00545 (mm, rad)".
std::string unidentifiable_as_motion(const Coupling& coupling, const ParameterMotion& motion);

/// What can be determined of an unidentifiable motion and what cannot, in one sentence, such as
/// "theta6 + a6/183.5 is identifiable, a6 alone is not".
std::string unidentifiable_in_words(const Coupling& coupling, const ParameterMotion& motion);

/// A weak direction: its larger parts, and whether it is mostly the scale.
std::string weak_in_words(const Coupling& coupling, const WeakDirection& weak);

}  // namespace artcal
