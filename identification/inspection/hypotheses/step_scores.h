#pragma once

#include <vector>

#include "acquisition/recording/recording.h"
#include "identification/problem/system.h"

namespace artcal {

/// In which order the readings stand before and after a slip: as they were taken, or by the joint's angle (an encoder
/// that wraps: above some angle another zero).
enum class SlipOrder { Time, Angle };

/// Indices of the readings in that order.
std::vector<int> readings_in_order(const Recording& recording, int joint, SlipOrder by);

/// A step of one joint's readings, from some place of an order on.
struct StepScore {
  int joint = 0;
  SlipOrder order = SlipOrder::Time;
  std::size_t place = 0;  ///< of the first reading after it, in that order
  double share = 0.0;     ///< of the sum of squared residuals that the step takes away, by the linearised fit
};

/// The best place of a step for each joint and order, the largest share first, by one linearisation: with P the
/// projection onto what the fit of the arm (under its weak prior) and of the unknowns leaves, a column s of the step's
/// derivatives takes (sᵀPr)²/sᵀPs off the residuals' rᵀPr (Rao's score test with one parameter). Running sums give it
/// for all places of an order at once. Empty where the readings do not determine the unknowns at System::start.
std::vector<StepScore> score_steps(const System& system, const Weights& weights, const Recording& recording);

}  // namespace artcal
