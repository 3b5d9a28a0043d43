#include "acquisition/recording_file.h"

#include <fmt/format.h>

#include "acquisition/arm_file.h"
#include "acquisition/readings_file.h"
#include "core/in_quotes.h"
#include "core/text_file.h"
#include "core/toml_document.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr std::string_view schema = "artcal-recording/1";

using Quantity = std::optional<double> (*)(std::string_view);

std::optional<double> noise_at(TomlTable& table, std::string_view key, Quantity read, std::string_view example) {
  if (!table.has(key)) {
    return std::nullopt;
  }
  const std::string text = table.text(key);
  const auto value = read(text);
  if (!value || *value <= 0.0) {
    table.fail(key, fmt::format("the noise `{}` is {}, expected a number above zero with its unit, such as \"{}\"", key,
                                in_quotes(text), example));
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
  return request;
}

void check_temperature_unit(TomlTable& units) {
  if (const std::string unit = units.text_or("temperature", "degC"); unit != "degC") {
    units.fail("temperature", fmt::format("{} is not a unit known for `temperature`, expected degC", in_quotes(unit)));
  }
}

}  // namespace

Expected<Recording> read_recording(const std::filesystem::path& path) {
  auto document = TomlDocument::read(path, schema);
  if (!document) {
    return tl::unexpected(document.error());
  }
  TomlTable& root = document->root();
  const std::filesystem::path folder = path.parent_path();
  Recording recording;
  recording.inputs.push_back({path.string(), document->sha256()});
  recording.name = root.name_or("name", at_most(80, path.stem().string()));
  recording.date = root.date_or("date", "");
  const std::string arm_path = root.text("arm");
  for (const auto& name : root.texts("artefacts")) {
    recording.artefact_paths.push_back((folder / name).string());
  }
  const auto readings_paths = root.texts("readings");
  if (readings_paths.empty()) {
    root.fail("readings", "the recording names no readings, expected readings = [\"readings.csv\"]");
  }
  TomlTable units = root.table("units");
  const ReadingUnits reading_units{angle_unit(units, "joint"), length_unit(units, "length")};
  check_temperature_unit(units);
  recording.noise = read_noise(root.table("noise"));
  recording.identify = read_request(root.table("identify"));
  if (auto finished = document->finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  auto arm = read_arm_file(folder / arm_path);
  if (!arm) {
    return tl::unexpected(arm.error());
  }
  recording.arm = std::move(arm->arm);
  recording.inputs.push_back(arm->input);
  for (const auto& name : readings_paths) {
    if (auto read = read_readings(folder / name, reading_units, recording); !read) {
      return tl::unexpected(read.error());
    }
  }
  recording.warnings = suspicious_angles(recording, reading_units.joint);
  return recording;
}

}  // namespace artcal
