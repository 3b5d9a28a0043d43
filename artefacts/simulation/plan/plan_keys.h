#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Core>

#include "core/toml/toml_document.h"
#include "core/unit_names.h"

namespace artcal {

/// What the tables of a plan have in common. Whatever is wrong is noted in the table.

/// A length such as "3 um" in mm or an angle such as "2 arcsec" in rad, zero or above; `fallback` if absent.
double length_at(TomlTable& table, std::string_view key, double fallback = 0.0);
double angle_at(TomlTable& table, std::string_view key, double fallback = 0.0);

/// A whole number between `low` and `high`.
int count_at(TomlTable& table, std::string_view key, int fallback, int low, int high);

/// A number between `low` and `high`.
double number_between(TomlTable& table, std::string_view key, double fallback, double low, double high);

/// Two or three numbers; nothing if absent.
std::optional<Eigen::Vector2d> pair_at(TomlTable& table, std::string_view key);
std::optional<Eigen::Vector3d> triple_at(TomlTable& table, std::string_view key);

/// Three numbers as a unit vector; nothing if absent or without a length.
std::optional<Eigen::Vector3d> direction_at(TomlTable& table, std::string_view key);

}  // namespace artcal
