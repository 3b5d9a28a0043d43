#pragma once

#include <cstdint>
#include <vector>

#include "identification/planning/design_goal.h"

namespace artcal {

/// Chooses `count` of the placements so that the lengths' predicted u becomes small, by exchange: the best is added,
/// then what is missed least is taken away, by excursions of up to three at once until none betters the choice (DETMAX:
/// Mitchell 1974), from `starts` random starts. `told` is what each placement tells of the common columns, `known`
/// what is known anyway. The choice in rising order; the same arguments give the same one.
/// REQUIRES: count is not more than there are.
std::vector<int> exchange_placements(const Eigen::MatrixXd& known, const std::vector<Eigen::MatrixXd>& told, int count,
                                     const TestLengths& lengths, Goal goal, int starts, std::uint64_t seed);

/// Exchanges the readings chosen of one placement (into PossiblePlacement::readings) for others of the same feature, as
/// long as that lowers the predicted u. `known` is what all else tells.
void exchange_readings(const PossiblePlacement& placement, const Eigen::MatrixXd& known, const TestLengths& lengths,
                       Goal goal, std::vector<int>& chosen);

}  // namespace artcal
