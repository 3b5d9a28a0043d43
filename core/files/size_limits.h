#pragma once

#include <cstddef>

/// The largest file of each kind that is read; docs/files.md states them too. What is larger is refused before it is
/// read.
namespace artcal::largest {

inline constexpr std::size_t mebibyte = std::size_t{1} << 20;
inline constexpr std::size_t gibibyte = std::size_t{1} << 30;

inline constexpr std::size_t toml = 16 * mebibyte;          ///< recordings, arms, artefacts, plans, specifications
inline constexpr std::size_t certificate = 16 * mebibyte;   ///< digital calibration certificates
inline constexpr std::size_t row_list = 256 * mebibyte;     ///< rows of a cloud to take
inline constexpr std::size_t result = 256 * mebibyte;       ///< results as JSON
inline constexpr std::size_t monte_carlo_state = gibibyte;  ///< states of a Monte Carlo
inline constexpr std::size_t readings = 4 * gibibyte;       ///< tables of readings
inline constexpr std::size_t points = 16 * gibibyte;        ///< clouds and scans
inline constexpr std::size_t any = points;                  ///< of whatever kind

inline constexpr std::size_t name = 1000;     ///< characters of a name or label
inline constexpr std::size_t path = 4095;     ///< bytes of a path, as Linux has it
inline constexpr std::size_t message = 2000;  ///< characters of a message

}  // namespace artcal::largest
