#pragma once

namespace artcal {

/// What both kinds of calibration certificate state: D-SI's name of the unit, and the coverage probability.
inline constexpr const char* dcc_millimetre = "\\milli\\metre";
inline constexpr double dcc_probability = 0.95;

}  // namespace artcal
