#pragma once

#include <string>
#include <vector>

#include "acquisition/arm/arm.h"
#include "app/stream/stream_event.h"

namespace artcal {

/// What to say where the coordinates that the arm's own software reports are not those of its joint angles by `arm`: by
/// more than a hundredth of the reach. Distances between the tips are compared, so that the software may have a frame
/// of its own. Another unit, two joints exchanged or one sign are named where one of them brings both together. Empty
/// where they agree. Events have coordinates; the arm's first probe counts.
std::string check_tips(const Arm& arm, const std::vector<StreamEvent>& events);

}  // namespace artcal
