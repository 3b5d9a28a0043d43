#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "identification/identify.h"
#include "identification/problem/system.h"
#include "identification/progress.h"
#include "identification/uncertainty/uncertain_arm.h"

namespace artcal {

/// An arm that was identified without one placement, and what its points are uncertain by.
struct ArmWithout {
  Arm arm;
  UncertaintySources sources;
};

/// Identifies an arm from constraints that lack one placement.
using IdentifyWithout = std::function<Expected<ArmWithout>(const Constraints&)>;

/// A faster way to the same arm; nothing where it cannot be had (PlacementRefit).
using RefitWithout = std::function<std::optional<ArmWithout>(int artefact, int placement)>;

/// How an arm without a placement is to be had, on how many threads (0: all), and who is told how many are done.
struct LeavingOut {
  RefitWithout refit;
  IdentifyWithout identify;
  int threads = 0;
  IdentifyProgressCallback progress{};
};

/// Leaves out each placement of each artefact in turn, identifies from the rest, and lets the result judge
/// the placement it has not seen. Nothing is left out where there are fewer than two placements. The
/// parts run side by side; each is alone with its numbers, so that the result does not depend on how many threads
/// there are. `readings` is make_system() of the recording, at any arm.
std::vector<LeftOut> leave_placements_out(const System& readings, const Recording& recording,
                                          const Constraints& constraints, const LeavingOut& leaving_out);

}  // namespace artcal
