#pragma once

#include <string>

namespace artcal {

/// What a person reads for the name that files and options have for a standard: "ISO 10360-12:2016" for "iso10360-12".
/// A name that is none of them stays as it is, shortened.
std::string standard_in_words(const std::string& name);

/// What octants and shares of the reach, by which places are told, mean.
inline constexpr const char* places_are =
    "octants are counted about the shoulder, the point on axis 1 at the height where joint 1 ends: above it 1 (+x +y), "
    "2 (-x +y), 3 (-x -y), 4 (+x -y), below it 5 to 8 in the same order; the percentage is the distance from the "
    "shoulder over the arm's reach.";

}  // namespace artcal
