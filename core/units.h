#pragma once

#include <numbers>

/// Units are converted once, where a file or the terminal is read or written. Inside artcal a length
/// is in millimetres, an angle in radians, a temperature in degrees Celsius.
///
///     double q = 12.5 * units::degree;        // into artcal
///     double shown = q / units::degree;       // out of artcal
namespace artcal::units {

inline constexpr double millimetre = 1.0;
inline constexpr double micrometre = 1e-3;
inline constexpr double metre = 1e3;
inline constexpr double inch = 25.4;

inline constexpr double radian = 1.0;
inline constexpr double milliradian = 1e-3;
inline constexpr double degree = std::numbers::pi / 180.0;
inline constexpr double arcsecond = degree / 3600.0;

}  // namespace artcal::units
