#pragma once

namespace artcal {

/// How a reading far off counts. Thresholds (1.345 and 2.385 standard deviations) are those of 95 %
/// efficiency on normal noise (Holland, Welsch 1977).
enum class Loss { None, Huber, Cauchy };

/// ρ(s) of a loss and its derivative at s, the squared residual in units of its variance. Both robust
/// losses are concave in s, which the solver relies on.
struct LossValue {
  double value = 0.0;
  double slope = 1.0;
};
LossValue loss_at(Loss loss, double s);

}  // namespace artcal
