#pragma once

#include <optional>

#include "acquisition/arm/arm.h"

namespace artcal {

/// By how much the lengths that an arm measures change, mm.
struct LengthChange {
  double rms = 0.0;
  double maximum = 0.0;
};

/// Of 500 lengths between two postures each, drawn at random between the end stops (without stops, from whole turns)
/// and the same in every call: length by `now` less length by `then` from the same joint angles, each arm at its
/// reference temperature and with its first probe. How the base stands does not matter to it. Nothing where the arms
/// have not as many joints.
std::optional<LengthChange> length_change(const Arm& then, const Arm& now);

}  // namespace artcal
