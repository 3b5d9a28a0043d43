#pragma once

#include "fitting/least_squares/estimate.h"

namespace artcal::fitting {

/// An estimate in the cloud's frame and unit, by the criterion that the options name. REQUIRES: the feature
/// has that criterion (check_options).
template <typename F>
Expected<Estimate<F>> estimate_by_criterion(const Cloud& cloud, const FitOptions& options);

}  // namespace artcal::fitting
