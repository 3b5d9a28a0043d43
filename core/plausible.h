#pragma once

/// Standard uncertainties and standard deviations of noise that a measurement can have. What lies outside is in a wrong
/// unit or a slip of the pen, and would leave the arithmetic without digits.
namespace artcal::plausible {

inline constexpr double least_length_u = 1e-15;  ///< mm, below the digits of a metre
inline constexpr double max_length_u = 1e3;      ///< mm
inline constexpr double least_angle_u = 1e-12;   ///< rad
inline constexpr double max_angle_u = 1.0;       ///< rad
inline constexpr const char* length_range = "1e-15 mm to 1000 mm";
inline constexpr const char* angle_range = "1e-12 rad to 1 rad";

inline bool is_length_u(double mm) { return mm >= least_length_u && mm <= max_length_u; }
inline bool is_angle_u(double rad) { return rad >= least_angle_u && rad <= max_angle_u; }

}  // namespace artcal::plausible
