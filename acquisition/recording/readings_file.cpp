#include "acquisition/recording/readings_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/csv/csv.h"
#include "acquisition/csv/csv_text.h"
#include "core/files/size_limits.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::string_view, 15> known_columns{
    "artefact", "placement", "feature", "orientation", "repeat", "probe", "temperature", "arm_temperature", "length",
    "ref_x",    "ref_y",     "ref_z",   "x",           "y",      "z"};

// The number n of a column called qn, or 0.
int joint_number(std::string_view name) {
  // Digits without a sign or a leading zero: q-1 and q01 are no joints.
  if (name.size() < 2 || name[0] != 'q' || name[1] < '1' || name[1] > '9') {
    return 0;
  }
  int number = 0;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
  return error == std::errc{} && end == name.data() + name.size() ? number : 0;
}

/// Where each thing stands in this file; nothing where the column is absent.
struct Columns {
  using Column = std::optional<std::size_t>;
  Column artefact, placement, feature, orientation, repeat, probe, temperature, arm_temperature, length;
  std::array<Column, 3> reference;
  std::array<Column, 3> tip;
  std::vector<std::size_t> joints;  // none in a file of coordinates alone
};

bool some_but_not_all(const std::array<Columns::Column, 3>& columns) {
  const auto& [x, y, z] = columns;
  return x.has_value() != y.has_value() || x.has_value() != z.has_value();
}

bool is_known(const std::string& name) {
  return joint_number(name) > 0 || std::find(known_columns.begin(), known_columns.end(), name) != known_columns.end();
}

// The path may lead to any file of this computer, whose content no message is to show.
std::string why_no_table(const std::vector<std::string>& header) {
  const bool is_table = std::any_of(header.begin(), header.end(), is_known);
  return is_table
             ? ""
             : fmt::format("this is no table of readings: its first line names none of the columns q1, q2, … and {}",
                           fmt::join(known_columns, ", "));
}

Expected<Columns> find_columns(const CsvReader& csv, const Arm& arm) {
  for (std::size_t i = 0; i < csv.header().size(); ++i) {
    const std::string& name = csv.header()[i];
    const bool known = std::find(known_columns.begin(), known_columns.end(), name) != known_columns.end();
    const int joint = joint_number(name);
    if (joint > static_cast<int>(arm.joints.size())) {
      return bad_input(fmt::format("there is a column {}, but the arm \"{}\" has {} joints; is it the right arm?", name,
                                   arm.name, arm.joints.size()),
                       csv.where(i));
    }
    if (!known && joint == 0 && !name.starts_with("x-")) {
      return bad_input(fmt::format("the column {} is not known, expected q1 … q{} and any of {}; columns of your "
                                   "own may begin with x-",
                                   in_quotes(name), arm.joints.size(), fmt::join(known_columns, ", ")),
                       csv.where(i));
    }
  }
  Columns columns{csv.column("artefact"),
                  csv.column("placement"),
                  csv.column("feature"),
                  csv.column("orientation"),
                  csv.column("repeat"),
                  csv.column("probe"),
                  csv.column("temperature"),
                  csv.column("arm_temperature"),
                  csv.column("length"),
                  {csv.column("ref_x"), csv.column("ref_y"), csv.column("ref_z")},
                  {csv.column("x"), csv.column("y"), csv.column("z")},
                  {}};
  if (some_but_not_all(columns.reference)) {
    return bad_input("reference coordinates need all three of ref_x, ref_y, ref_z", csv.where(0));
  }
  if (some_but_not_all(columns.tip)) {
    return bad_input("the tip's coordinates need all three of x, y, z", csv.where(0));
  }
  const bool any_joint = std::any_of(csv.header().begin(), csv.header().end(),
                                     [](const std::string& name) { return joint_number(name) > 0; });
  if (columns.tip[0] && !any_joint) {
    return columns;
  }
  if (arm.joints.empty()) {
    return bad_input("the recording names no arm, so that its readings need the tip's coordinates x, y, z",
                     csv.where(0));
  }
  for (std::size_t i = 1; i <= arm.joints.size(); ++i) {
    const auto column = csv.column(fmt::format("q{}", i));
    if (!column) {
      return bad_input(fmt::format("the column q{} is missing; the arm \"{}\" has {} joints, expected q1 … q{}", i,
                                   arm.name, arm.joints.size(), arm.joints.size()),
                       csv.where(0));
    }
    columns.joints.push_back(*column);
  }
  return columns;
}

// A number where the file has the column and the field; NaN where either is absent.
Expected<double> optional_number(const CsvReader& csv, Columns::Column column, double unit, std::string_view expected) {
  if (!column || csv.field(*column).empty()) {
    return nan;
  }
  return csv.number(*column, expected).map([unit](double value) { return value * unit; });
}

int label(Labels& labels, const CsvReader& csv, Columns::Column column) {
  return labels.index_of(column ? without_guard(csv.field(*column)) : std::string_view{});
}

Expected<void> check_labels(const CsvReader& csv, const Columns& columns) {
  for (const auto& column :
       {columns.artefact, columns.placement, columns.feature, columns.orientation, columns.repeat, columns.probe}) {
    if (column && csv.field(*column).size() > largest::name && character_count(csv.field(*column)) > largest::name) {
      return bad_input(
          fmt::format("column {}: found the label {} of {} characters, expected at most {}", csv.header()[*column],
                      in_quotes(csv.field(*column)), character_count(csv.field(*column)), largest::name),
          csv.where(*column));
    }
  }
  return {};
}

Expected<int> find_probe(const CsvReader& csv, Columns::Column column, const Arm& arm) {
  const std::string name(column ? without_guard(csv.field(*column)) : std::string_view{});
  if (name.empty() && arm.probes.size() == 1) {
    return 0;
  }
  const int index = probe_index(arm, name);
  if (index >= 0) {
    return index;
  }
  std::string known;
  for (const Probe& probe : arm.probes) {
    known += (known.empty() ? "" : ", ") + probe.name;
  }
  return bad_input(name.empty()
                       ? fmt::format("the reading names no probe, and the arm has several: {}", known)
                       : fmt::format("the reading names the probe {}, expected one of: {}", in_quotes(name), known),
                   csv.where(column.value_or(0)));
}

Expected<Reading> read_labels_and_extras(const CsvReader& csv, const Columns& columns, const ReadingUnits& units,
                                         Recording& recording) {
  if (auto checked = check_labels(csv, columns); !checked) {
    return tl::unexpected(checked.error());
  }
  Reading reading{};
  reading.artefact = label(recording.artefacts, csv, columns.artefact);
  reading.placement = label(recording.placements, csv, columns.placement);
  reading.feature = label(recording.features, csv, columns.feature);
  reading.orientation = label(recording.orientations, csv, columns.orientation);
  reading.repeat = label(recording.repeats, csv, columns.repeat);
  reading.line = csv.line();
  const auto probe = find_probe(csv, columns.probe, recording.arm);
  const auto temperature = optional_number(csv, columns.temperature, 1.0, "a temperature in degC");
  const auto arm_temperature = optional_number(csv, columns.arm_temperature, 1.0, "a temperature in degC");
  const auto length = optional_number(csv, columns.length, units.length, "a length");
  for (const Error* error :
       {probe ? nullptr : &probe.error(), temperature ? nullptr : &temperature.error(),
        arm_temperature ? nullptr : &arm_temperature.error(), length ? nullptr : &length.error()}) {
    if (error != nullptr) {
      return tl::unexpected(*error);
    }
  }
  reading.probe = *probe;
  reading.temperature = *temperature;
  reading.arm_temperature = *arm_temperature;
  reading.length = *length;
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = optional_number(csv, columns.reference[axis], units.length, "a coordinate");
    if (!value) {
      return tl::unexpected(value.error());
    }
    reading.reference[axis] = *value;
    if (columns.tip[axis]) {
      const auto coordinate = csv.number(*columns.tip[axis], "a coordinate");
      if (!coordinate) {
        return tl::unexpected(coordinate.error());
      }
      reading.tip[axis] = *coordinate * units.length;
    }
  }
  return reading;
}

}  // namespace

Expected<void> read_readings(const std::filesystem::path& path, const ReadingUnits& units, Recording& recording) {
  const auto file = read_text_file(path, largest::readings);
  if (!file) {
    return tl::unexpected(file.error());
  }
  auto csv = CsvReader::open(*file, why_no_table);
  if (!csv) {
    return tl::unexpected(csv.error());
  }
  const auto columns = find_columns(*csv, recording.arm);
  if (!columns) {
    return tl::unexpected(columns.error());
  }
  recording.inputs.push_back({path.string(), file->sha256});
  recording.files.push_back(path.string());
  const std::string_view angle = units.joint == units::degree ? "an angle in deg" : "an angle";
  std::vector<double> q;
  const std::size_t before = recording.readings.size();
  for (;;) {
    const auto found = csv->next();
    if (!found) {
      return tl::unexpected(found.error());
    }
    if (!*found) {
      break;
    }
    auto reading = read_labels_and_extras(*csv, *columns, units, recording);
    if (!reading) {
      return tl::unexpected(reading.error());
    }
    reading->file = static_cast<int>(recording.files.size()) - 1;
    for (std::size_t j = 0; j < columns->joints.size(); ++j) {
      const bool slides = recording.arm.joints[j].is_prismatic();
      const auto value = csv->number(columns->joints[j], slides ? "a length" : angle);
      if (!value) {
        return tl::unexpected(value.error());
      }
      q.push_back(*value * (slides ? units.length : units.joint));
    }
    recording.readings.push_back(*reading);
  }
  const auto end = csv->check_end();
  if (!end) {
    return tl::unexpected(end.error());
  }
  recording.warnings.insert(recording.warnings.end(), end->begin(), end->end());
  const auto count = static_cast<Eigen::Index>(recording.readings.size() - before);
  if (count == 0) {
    return bad_input("the file has a header but no readings", path.string());
  }
  const auto joints = static_cast<Eigen::Index>(recording.arm.joints.size());
  recording.joints.conservativeResize(joints, recording.joints.cols() + count);
  auto added = recording.joints.rightCols(count);
  if (columns->joints.empty()) {
    added.setConstant(nan);
  } else {
    added = Eigen::MatrixXd::Map(q.data(), joints, count);
  }
  return {};
}

std::vector<std::string> suspicious_angles(const Recording& recording, double joint_unit) {
  double largest = 0.0;  // rad; readings without joint angles have NaN
  for (Eigen::Index joint = 0; joint < recording.joints.rows(); ++joint) {
    if (recording.arm.joints[static_cast<std::size_t>(joint)].is_prismatic()) {
      continue;
    }
    for (const double q : recording.joints.row(joint)) {
      largest = std::abs(q) > largest ? std::abs(q) : largest;
    }
  }
  std::vector<std::string> warnings;
  if (joint_unit == units::degree && recording.readings.size() >= 5 && largest > 0.0 &&
      largest / units::degree <= 2 * std::numbers::pi) {
    warnings.push_back(
        fmt::format("no joint reads more than {:.3g} degrees: these angles look like radians, but the "
                    "recording says units.joint = \"deg\"",
                    largest / units::degree));
  }
  if (joint_unit == units::radian && largest > 4 * std::numbers::pi) {
    warnings.push_back(
        fmt::format("a joint reads {:.4g} rad, more than two turns: these angles look like degrees, but "
                    "the recording says units.joint = \"rad\"",
                    largest));
  }
  return warnings;
}

}  // namespace artcal
