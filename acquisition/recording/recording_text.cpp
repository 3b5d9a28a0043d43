#include "acquisition/recording/recording_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "acquisition/csv/csv_text.h"
#include "core/toml/toml_text.h"
#include "core/units.h"

namespace artcal {
namespace {

bool tells(const Labels& labels) { return labels.size() > 1 || (labels.size() == 1 && !labels.name(0).empty()); }

std::string number_or_nothing(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "";
}

/// A column: its name, and what stands in it.
struct Column {
  const char* name;
  std::string (*field)(const Recording&, const Reading&);
};

std::vector<Column> columns_of(const Recording& recording) {
  const auto any = [&](auto has) { return std::any_of(recording.readings.begin(), recording.readings.end(), has); };
  std::vector<Column> columns;
  if (tells(recording.artefacts)) {
    columns.push_back(
        {"artefact", [](const Recording& r, const Reading& x) { return csv_field(r.artefacts.name(x.artefact)); }});
  }
  if (tells(recording.placements)) {
    columns.push_back(
        {"placement", [](const Recording& r, const Reading& x) { return csv_field(r.placements.name(x.placement)); }});
  }
  if (tells(recording.features)) {
    columns.push_back(
        {"feature", [](const Recording& r, const Reading& x) { return csv_field(r.features.name(x.feature)); }});
  }
  if (tells(recording.orientations)) {
    columns.push_back({"orientation", [](const Recording& r, const Reading& x) {
                         return csv_field(r.orientations.name(x.orientation));
                       }});
  }
  if (tells(recording.repeats)) {
    columns.push_back(
        {"repeat", [](const Recording& r, const Reading& x) { return csv_field(r.repeats.name(x.repeat)); }});
  }
  if (recording.arm.probes.size() > 1) {
    columns.push_back(
        {"probe", [](const Recording& r, const Reading& x) { return csv_field(r.arm.probes[x.probe].name); }});
  }
  if (any([](const Reading& x) { return std::isfinite(x.temperature); })) {
    columns.push_back(
        {"temperature", [](const Recording&, const Reading& x) { return number_or_nothing(x.temperature, 4); }});
  }
  if (any([](const Reading& x) { return std::isfinite(x.arm_temperature); })) {
    columns.push_back({"arm_temperature",
                       [](const Recording&, const Reading& x) { return number_or_nothing(x.arm_temperature, 4); }});
  }
  if (any([](const Reading& x) { return std::isfinite(x.length); })) {
    columns.push_back({"length", [](const Recording&, const Reading& x) { return number_or_nothing(x.length, 9); }});
  }
  if (any([](const Reading& x) { return x.reference.allFinite(); })) {
    columns.push_back(
        {"ref_x", [](const Recording&, const Reading& x) { return number_or_nothing(x.reference.x(), 9); }});
    columns.push_back(
        {"ref_y", [](const Recording&, const Reading& x) { return number_or_nothing(x.reference.y(), 9); }});
    columns.push_back(
        {"ref_z", [](const Recording&, const Reading& x) { return number_or_nothing(x.reference.z(), 9); }});
  }
  return columns;
}

std::string scan_text(const RecordedScan& scan) {
  std::string text = "\n[[scan]]\n";
  for (const auto& [key, value] : {std::pair("file", &scan.path),
                                   {"placement", &scan.placement},
                                   {"artefact", &scan.artefact},
                                   {"probe", &scan.probe},
                                   {"orientation", &scan.orientation},
                                   {"repeat", &scan.repeat}}) {
    text += value->empty() ? "" : fmt::format("{} = {}\n", key, toml_text(*value));
  }
  for (const auto& [key, value] :
       {std::pair("temperature", scan.temperature), std::pair("arm_temperature", scan.arm_temperature)}) {
    text += value ? fmt::format("{} = {:.4f}\n", key, *value) : "";
  }
  return text;
}

}  // namespace

std::string readings_file_text(const Recording& recording) {
  const auto columns = columns_of(recording);
  fmt::memory_buffer out;
  const auto to = std::back_inserter(out);
  for (const Column& column : columns) {
    fmt::format_to(to, "{},", column.name);
  }
  const Eigen::Index joints = recording.joints.rows();
  for (Eigen::Index j = 0; j < joints; ++j) {
    fmt::format_to(to, "q{}{}", j + 1, j + 1 < joints ? "," : "\n");
  }
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    for (const Column& column : columns) {
      fmt::format_to(to, "{},", column.field(recording, recording.readings[i]));
    }
    for (Eigen::Index j = 0; j < joints; ++j) {
      const double unit = recording.arm.joints[static_cast<std::size_t>(j)].is_prismatic() ? 1.0 : units::degree;
      fmt::format_to(to, "{:.12f}{}", recording.joints(j, static_cast<Eigen::Index>(i)) / unit,
                     j + 1 < joints ? "," : "\n");
    }
  }
  return fmt::to_string(out);
}

std::string recording_file_text(const Recording& recording, const RecordingFiles& files,
                                const std::vector<std::string>& comment) {
  std::string text;
  for (const auto& line : comment) {
    text += fmt::format("# {}\n", line);
  }
  text += fmt::format("schema = \"artcal-recording/1\"\nname = {}\narm = {}\nartefacts = [", toml_text(recording.name),
                      toml_text(files.arm));
  for (std::size_t i = 0; i < files.artefacts.size(); ++i) {
    text += (i == 0 ? "" : ", ") + toml_text(files.artefacts[i]);
  }
  text += "]\n";
  if (!recording.readings.empty()) {
    text += fmt::format("readings = [{}]\n", toml_text(files.readings));
  }
  text += "units = { joint = \"deg\", length = \"mm\" }\n";
  const Noise& noise = recording.noise;
  if (noise.reading) {
    text += fmt::format("\n[noise]\nreading = \"{} um\"\n", *noise.reading / units::micrometre);
  } else if (noise.encoder && noise.probing) {
    text += fmt::format("\n[noise]\nencoder = \"{:.9g} arcsec\"\nprobing = \"{:.9g} um\"\n",
                        *noise.encoder / units::arcsecond, *noise.probing / units::micrometre);
  }
  for (const RecordedScan& scan : recording.scans) {
    text += scan_text(scan);
  }
  return text;
}

}  // namespace artcal
