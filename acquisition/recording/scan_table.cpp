#include "acquisition/recording/scan_table.h"

#include <cmath>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

std::optional<double> tolerance_of(TomlTable& table) {
  if (!table.has("tolerance")) {
    return std::nullopt;
  }
  const std::string text = table.text("tolerance");
  const auto value = length_quantity(text);
  if (!value || *value <= 0.0) {
    table.fail("tolerance", fmt::format("the tolerance is {}, expected a length above zero with its unit, such as "
                                        "\"5 mm\"",
                                        in_quotes(text)));
  }
  return value;
}

std::optional<double> temperature_at(TomlTable& table, std::string_view key) {
  constexpr double absolute_zero = -273.15;
  const auto temperature = table.optional_number(key);
  if (temperature && !(*temperature > absolute_zero && *temperature < 1e4)) {
    table.fail(key, fmt::format("the temperature is {}, expected degC", *temperature));
  }
  return temperature;
}

int use_every_of(TomlTable& table) {
  const double every = table.number_or("use_every", 1.0);
  if (!(every >= 1.0 && every <= 1e6) || every != std::floor(every)) {
    table.fail("use_every", fmt::format("use_every is {}, expected a whole number from 1 to 1000000", every));
    return 1;
  }
  return static_cast<int>(every);
}

SpherePlace place_of(TomlTable table, double unit) {
  SpherePlace place{table.name("sphere"), Eigen::Vector3d::Zero()};
  const auto at = table.numbers("at");
  if (at.size() != 3) {
    table.fail("at", fmt::format("`at` has {} numbers, expected three: [x, y, z] in the arm's base frame", at.size()));
    return place;
  }
  place.at_in_base = unit * Eigen::Vector3d(at[0], at[1], at[2]);
  return place;
}

}  // namespace

RecordedScan read_scan_table(TomlTable table, const std::filesystem::path& folder, const FileAccess& access,
                             const CloudUnits& units) {
  RecordedScan scan;
  scan.where = table.where("file");
  const std::string name = table.name("file");
  if (const auto file = access.resolve(folder, name, scan.where); file) {
    scan.path = file->string();
  } else {
    table.fail("file", file.error().message);
  }
  scan.placement = table.name("placement");
  scan.artefact = table.name_or("artefact", "");
  scan.probe = table.name_or("probe", "");
  scan.orientation = table.name_or("orientation", "");
  scan.repeat = table.name_or("repeat", "");
  scan.temperature = temperature_at(table, "temperature");
  scan.arm_temperature = temperature_at(table, "arm_temperature");
  scan.units = units;
  if (table.has("units")) {
    TomlTable own = table.table("units");
    scan.units = {length_unit(own, "length"), own.has("joint") ? angle_unit(own, "joint") : units.angle};
  }
  scan.tolerance = tolerance_of(table);
  scan.use_every = use_every_of(table);
  for (const TomlTable& place : table.tables("place")) {
    scan.places.push_back(place_of(place, scan.units.length));
  }
  return scan;
}

}  // namespace artcal
