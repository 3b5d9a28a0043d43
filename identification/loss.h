#pragma once

namespace artcal {

/// How a reading far off counts. Thresholds (1.345 and 2.385 standard deviations) are those of 95 %
/// efficiency on normal noise (Holland, Welsch 1977).
enum class Loss { None, Huber, Cauchy };

}  // namespace artcal
