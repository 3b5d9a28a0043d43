#pragma once

namespace artcal {

/// What a plan is to make small.
enum class Goal { Worst, Mean };

/// Predicted standard uncertainty of the lengths, mm.
struct PredictedU {
  double worst = 0.0;
  double mean = 0.0;  ///< root of the mean square
};

}  // namespace artcal
