#pragma once

#include <string>
#include <vector>

#include "acquisition/arm/arm.h"
#include "app/stream/stream_event.h"

namespace artcal {

/// Of the reach: no arm is that far from its file.
inline constexpr double max_deviation = 0.01;

/// What to say where the coordinates that the arm's own software reports are not those of its joint angles by `arm`: by
/// more than a hundredth of the reach, rms, after the rigid motion that brings them together best (the software may
/// have a frame of its own). Another unit, joints in another order or signs are named where one of them brings both
/// together. Empty where they agree. Events have coordinates; at least four. `probe` is into Arm::probes.
std::string check_tips(const Arm& arm, int probe, const std::vector<StreamEvent>& events);

}  // namespace artcal
