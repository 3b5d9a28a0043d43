#pragma once

#include <functional>
#include <vector>

#include "identification/identify.h"

namespace artcal {

/// Identifies an arm from constraints that lack one placement.
using IdentifyWithout = std::function<Expected<Arm>(const Constraints&)>;

/// Leaves out each placement of each artefact in turn, identifies from the rest, and lets the result judge
/// the placement it has not seen. Nothing is left out where there are fewer than two placements. The
/// parts run side by side on `threads` threads (0: all); each is alone with its numbers, so that the
/// result does not depend on how many there are.
std::vector<LeftOut> leave_placements_out(const Recording& recording, const Constraints& constraints,
                                          const IdentifyWithout& identify_without, int threads);

}  // namespace artcal
