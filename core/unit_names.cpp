#include "core/unit_names.h"

#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

using Unit = std::pair<std::string_view, double>;
constexpr std::array<Unit, 5> lengths{{{"mm", units::millimetre},
                                       {"um", units::micrometre},
                                       {"µm", units::micrometre},
                                       {"m", units::metre},
                                       {"in", units::inch}}};
constexpr std::array<Unit, 4> angles{
    {{"rad", units::radian}, {"mrad", units::milliradian}, {"deg", units::degree}, {"arcsec", units::arcsecond}}};
constexpr std::array<Unit, 5> ratios{{{"um/m", 1e-6}, {"µm/m", 1e-6}, {"ppm", 1e-6}, {"mm/m", 1e-3}, {"mm/mm", 1.0}}};
constexpr std::array<Unit, 2> temperatures{{{"K", 1.0}, {"mK", 1e-3}}};

std::optional<double> find(std::span<const Unit> known, std::string_view name) {
  for (const auto& [unit, factor] : known) {
    if (unit == name) {
      return factor;
    }
  }
  return std::nullopt;
}

std::optional<double> quantity(std::span<const Unit> known, std::string_view text) {
  double number = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || !std::isfinite(number) || number < 0.0) {
    return std::nullopt;
  }
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  while (text.starts_with(' ')) {
    text.remove_prefix(1);
  }
  const auto factor = find(known, text);
  return factor && std::isfinite(number * *factor) ? std::optional(number * *factor) : std::nullopt;
}

double unit_at(std::span<const Unit> known, TomlTable& units, std::string_view key, std::string_view choices) {
  if (!units.has(key)) {
    units.fail(
        key, fmt::format("the unit `{}` is not stated; write {} = \"…\" under [units], one of {}", key, key, choices));
    return 1.0;
  }
  const std::string name = units.text(key);
  const auto factor = find(known, name);
  if (!factor) {
    units.fail(key, fmt::format("{} is not a unit known for `{}`, expected one of {}", in_quotes(name), key, choices));
  }
  return factor.value_or(1.0);
}

}  // namespace

std::optional<double> length_unit(std::string_view name) { return find(lengths, name); }
std::optional<double> angle_unit(std::string_view name) { return find(angles, name); }
std::optional<double> length_quantity(std::string_view text) { return quantity(lengths, text); }
std::optional<double> angle_quantity(std::string_view text) { return quantity(angles, text); }
std::optional<double> temperature_difference(std::string_view text) { return quantity(temperatures, text); }
std::optional<double> ratio_quantity(std::string_view text) { return quantity(ratios, text); }

double length_unit(TomlTable& units, std::string_view key) { return unit_at(lengths, units, key, "mm, um, m, in"); }
double angle_unit(TomlTable& units, std::string_view key) {
  return unit_at(angles, units, key, "deg, rad, mrad, arcsec");
}

}  // namespace artcal
