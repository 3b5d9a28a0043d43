#include "acquisition/recording/recording_file.h"

#include <set>

#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/recording/readings_file.h"
#include "acquisition/recording/scan_table.h"
#include "core/files/text_file.h"
#include "core/plausible.h"
#include "core/text/decimal_comma.h"
#include "core/text/in_quotes.h"
#include "core/toml/toml_document.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr std::string_view recording_schema = "artcal-recording/1";

using Quantity = std::optional<double> (*)(std::string_view);

std::optional<double> noise_at(TomlTable& table, std::string_view key, Quantity read, std::string_view example) {
  if (!table.has(key)) {
    return std::nullopt;
  }
  const std::string text = table.text(key);
  const auto value = read(text);
  if (!value || *value <= 0.0) {
    table.fail(key, fmt::format("the noise `{}` is {}, expected a number above zero with its unit, such as \"{}\"{}",
                                key, in_quotes(text), example, decimal_comma_question(text)));
  } else if (read == angle_quantity ? !plausible::is_angle_u(*value) : !plausible::is_length_u(*value)) {
    table.fail(key,
               fmt::format("the noise `{}` is {}, expected a standard deviation of {}; is the unit right?", key,
                           in_quotes(text), read == angle_quantity ? plausible::angle_range : plausible::length_range));
  }
  return value;
}

Noise read_noise(TomlTable table) {
  Noise noise;
  noise.reading = noise_at(table, "reading", length_quantity, "15 um");
  noise.encoder = noise_at(table, "encoder", angle_quantity, "2 arcsec");
  noise.probing = noise_at(table, "probing", length_quantity, "3 um");
  if (noise.reading && (noise.encoder || noise.probing)) {
    table.fail("reading", "noise is stated either as `reading`, or as `encoder` and `probing`, not both");
  }
  if (noise.encoder.has_value() != noise.probing.has_value()) {
    table.fail("encoder", "`encoder` and `probing` noise belong together; state both");
  }
  return noise;
}

IdentifyRequest read_request(TomlTable table) {
  IdentifyRequest request;
  request.hold = table.texts("hold");
  request.free = table.texts("free");
  request.loss = table.text_or("loss", request.loss);
  if (request.loss != "none" && request.loss != "huber" && request.loss != "cauchy") {
    table.fail("loss", fmt::format("loss is {}, expected \"none\", \"huber\" or \"cauchy\"", in_quotes(request.loss)));
  }
  request.model = table.text_or("model", request.model);
  return request;
}

VerifyRequest read_verify_request(TomlTable table) {
  VerifyRequest request{table.text("standard")};
  if (request.standard != "iso10360-12" && request.standard != "b89.4.22" && request.standard != "sphere-plate") {
    table.fail("standard", fmt::format("standard is {}, expected \"iso10360-12\", \"b89.4.22\" or \"sphere-plate\"",
                                       in_quotes(request.standard)));
  }
  return request;
}

void check_temperature_unit(TomlTable& units) {
  if (const std::string unit = units.text_or("temperature", "degC"); unit != "degC") {
    units.fail("temperature", fmt::format("{} is not a unit known for `temperature`, expected degC", in_quotes(unit)));
  }
}

// Rows of a table that is named twice would count twice.
void check_named_once(TomlTable& root, const std::filesystem::path& folder, const std::vector<std::string>& names) {
  std::set<std::filesystem::path> files;
  for (const std::string& name : names) {
    std::error_code error;
    const auto whole = std::filesystem::weakly_canonical(folder / name, error);
    if (!files.insert(error ? folder / name : whole).second) {
      root.fail("readings",
                fmt::format("`readings` names the table {} twice; its readings would count twice. Leave one "
                            "of them out",
                            in_quotes(name)));
    }
  }
}

// An arm of which nothing is known but its tips: its own software says where they were.
Arm arm_of_probes(TomlTable& root, double length) {
  Arm arm;
  arm.name = root.name_or("arm_name", "arm");
  for (auto& table : root.tables("probe")) {
    Probe probe;
    probe.name = table.name_or("name", probe.name);
    probe.radius = table.number("radius") * length;
    if (probe.radius < 0.0) {
      table.fail("radius", "the radius of a tip is negative");
    }
    if (probe_index(arm, probe.name) >= 0) {
      table.fail("name", fmt::format("two probes are called {}; give each its own name", in_quotes(probe.name)));
    }
    arm.probes.push_back(probe);
  }
  if (arm.probes.empty()) {
    root.fail("probe", "the recording lists no probe, expected a table headed [[probe]] or arm = \"arm.toml\"");
  }
  return arm;
}

}  // namespace

Expected<Recording> read_recording(const std::filesystem::path& path) {
  return read_recording(path, FileAccess::anywhere());
}

Expected<Recording> read_recording(const std::filesystem::path& path, const FileAccess& access) {
  auto document = TomlDocument::read(path, recording_schema);
  if (!document) {
    return tl::unexpected(document.error());
  }
  TomlTable& root = document->root();
  const std::filesystem::path folder = path.parent_path();
  Recording recording;
  recording.inputs.push_back({path.string(), document->sha256()});
  recording.name = root.name_or("name", truncated(80, path.stem().string()));
  recording.date = root.date_or("date", "");
  const std::string arm_path = root.has("probe") ? "" : root.text("arm");
  if (root.has("probe") && root.has("arm")) {
    root.fail("probe", "a recording names an arm, which has its probes, or lists probes itself, not both");
  }
  const auto file_at = [&](std::string_view key, const std::string& name) {
    const auto file = access.resolve(folder, name, root.where(key));
    if (!file) {
      root.fail(key, file.error().message);
    }
    return file.value_or(std::filesystem::path{});
  };
  if (!arm_path.empty()) {
    file_at("arm", arm_path);
  }
  for (const auto& name : root.texts("artefacts")) {
    recording.artefact_paths.push_back(file_at("artefacts", name).string());
  }
  const auto readings_paths = root.texts("readings");
  for (const auto& name : readings_paths) {
    file_at("readings", name);
  }
  const auto scan_tables = root.tables("scan");
  if (readings_paths.empty() && scan_tables.empty()) {
    root.fail("readings",
              "the recording names no readings, expected readings = [\"readings.csv\"], or scans as [[scan]]");
  }
  check_named_once(root, folder, readings_paths);
  if (root.has("specification")) {
    recording.specification_path = file_at("specification", root.text("specification")).string();
  }
  TomlTable units = root.table("units");
  // Without an arm there are no joints to have a unit.
  const double joint_unit = arm_path.empty() && !units.has("joint") ? 1.0 : angle_unit(units, "joint");
  const ReadingUnits reading_units{joint_unit, length_unit(units, "length")};
  check_temperature_unit(units);
  if (root.has("probe")) {
    recording.arm = arm_of_probes(root, reading_units.length);
  }
  for (const TomlTable& table : scan_tables) {
    recording.scans.push_back(read_scan_table(table, folder, access, {reading_units.length, reading_units.joint}));
  }
  recording.noise = read_noise(root.table("noise"));
  recording.identify = read_request(root.table("identify"));
  if (root.has("verify")) {
    recording.verify = read_verify_request(root.table("verify"));
    recording.identify.asked = root.has("identify");
  }
  if (auto finished = document->finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  if (!arm_path.empty()) {
    auto arm = read_arm_file(folder / arm_path);
    if (!arm) {
      return tl::unexpected(arm.error());
    }
    recording.arm = std::move(arm->arm);
    recording.arm_identification = std::move(arm->identification);
    recording.inputs.push_back(arm->input);
  }
  for (const auto& name : readings_paths) {
    if (auto read = read_readings(folder / name, reading_units, recording); !read) {
      return tl::unexpected(read.error());
    }
  }
  if (!recording.readings.empty()) {
    const auto suspicious = suspicious_angles(recording, reading_units.joint);
    recording.warnings.insert(recording.warnings.end(), suspicious.begin(), suspicious.end());
  }
  return recording;
}

}  // namespace artcal
