#pragma once

#include <map>

#include "identification/uncertainty/redundancy.h"

namespace artcal {

/// Moments of a loss by degrees of freedom, which are rounded to a twentieth: each is integrated once.
class MomentsTable {
 public:
  explicit MomentsTable(Loss loss) : loss_(loss) {}
  const LossMoments& at(double degrees_of_freedom);

 private:
  Loss loss_;
  std::map<int, LossMoments> known_;
};

/// Lets a loss measure every observation, certificates too, by the variance that its residual has in this fit. Without
/// it a certificate that readings cannot match is never far off: the fit bends the readings, whose many weights give
/// way together.
void set_variances(const Redundancy& redundancy, Weights& weights);

/// Factor by which the noise in use is to be multiplied for the readings' residuals to have their expected median
/// size: the median over the readings of |r| by the median that it has at their variance and freedom. Half of the
/// readings may be wrong. 1 where the fit adapts to all of them.
double median_noise_factor(const WhitenedResiduals& residuals, const Redundancy& redundancy);

/// Weights of the observations as they count: weights·√(ρ'·information), so that least squares with them have the
/// covariance of the M-estimate (moments_of()) and the observations that were let go of add nothing to it.
Weights counted_weights(const Weights& weights, Loss loss, const LossWeights& counted, const Redundancy& redundancy);

}  // namespace artcal
