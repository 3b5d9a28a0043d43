#pragma once

#include <cstddef>
#include <vector>

namespace artcal {

/// Eight readings on one ball or at given distances from one point, a lane each, as ForwardKinematics::tips_in_base()
/// gives them: `tips` are [3][8] and `derivative` [columns][3][8]. What they mean: |tip − centre| − length, times
/// weight.
struct BallReadings {
  const double* tips;
  const double* derivative;
  int columns;
  double centre[3];
  double lengths[8];
  double weights[8];
};

/// Puts of the first `count` lanes into rows that begin at `stride` numbers from one another: the weighted residual at
/// `residuals`, its derivative by the centre at `by_centre` (three) and by the parameters at `by_arm` (columns, each
/// times its `scale`). The last two may be null. Each lane has the operations of FeatureResidual::at() and of its rows
/// in their order, so that every variant gives the same bits.
using BallRows = void(const BallReadings& readings, const double* scale, int count, std::ptrdiff_t stride,
                      double* residuals, double* by_centre, double* by_arm);

/// The same for instruction sets that this machine has; the fastest is the last.
struct BallRowsVariant {
  const char* instructions;
  BallRows* put;
};
const std::vector<BallRowsVariant>& ball_rows_variants();

}  // namespace artcal
