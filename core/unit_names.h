#pragma once

#include <optional>
#include <string_view>

#include "core/toml/toml_document.h"

namespace artcal {

/// The factor from a unit's name to mm, or nothing if the name is not known: mm, um (µm), m, in.
std::optional<double> length_unit(std::string_view name);
/// The factor from a unit's name to rad: rad, mrad, deg, arcsec.
std::optional<double> angle_unit(std::string_view name);

/// A text such as "15 um" or "2 arcsec", in mm or rad; nothing if it is not a number ≥ 0 and such a unit.
std::optional<double> length_quantity(std::string_view text);
std::optional<double> angle_quantity(std::string_view text);
/// A text such as "0.1 K" or "100 mK", in K; nothing if it is not a number ≥ 0 and such a unit.
std::optional<double> temperature_difference(std::string_view text);
/// A text such as "1.2 um/m", a length per length; also mm/m, ppm and mm/mm. Nothing if it is not a number ≥ 0 and
/// such a unit.
std::optional<double> ratio_quantity(std::string_view text);

/// The unit named under `key` in a table of units; a missing or unknown one is noted as an error.
double length_unit(TomlTable& units, std::string_view key);
double angle_unit(TomlTable& units, std::string_view key);

}  // namespace artcal
