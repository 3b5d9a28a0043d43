#pragma once

#include "app/report/sheet.h"
#include "app/results/identification/recorded/recorded_parameters.h"

namespace artcal {

/// The correlation matrix of the identified parameters, with the closest pairs in words.
Figure correlation_of(const RecordedCovariance& covariance);

}  // namespace artcal
