#pragma once

#include <vector>

#include "identification/covariance.h"
#include "identification/identify.h"

namespace artcal {

/// Readings whose whitened residual is longer than one in twenty sound recordings would show anywhere:
/// |r|² above the 1 − 0.05/n quantile of χ² with the residual's dimension, n readings. The worst first.
/// They are listed, never left out.
std::vector<Outlier> find_outliers(const Recording& recording, const Constraints& constraints,
                                   const WhitenedResiduals& residuals, const Evaluation& evaluation);

}  // namespace artcal
