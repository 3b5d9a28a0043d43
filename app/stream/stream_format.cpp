#include "app/stream/stream_format.h"

#include <cctype>
#include <numbers>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "core/toml/toml_document.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr std::string_view schema = "artcal-stream/1";

bool is_column(const std::string& field) {
  int number = 0;
  for (const char c : field) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0 || number > 999) {
      return false;
    }
    number = 10 * number + (c - '0');
  }
  return number > 0;
}

std::optional<StreamCondition> read_condition(TomlTable& root, std::string_view key) {
  if (!root.has(key)) {
    return std::nullopt;
  }
  TomlTable table = root.table(key);
  return StreamCondition{table.text("field"), table.number("value")};
}

void read_scales(TomlTable& root, StreamFormat& format) {
  const auto counts = root.has("counts_per_turn") ? root.numbers("counts_per_turn") : std::vector<double>();
  TomlTable units = root.table("units");
  if (counts.empty()) {
    const std::string unit = units.text("joint");
    const auto scale = angle_unit(unit);
    if (!scale) {
      units.fail("joint",
                 fmt::format("{} is not a unit known for `joint`, expected deg, rad, mrad or arcsec", in_quotes(unit)));
    }
    format.joint_scale.assign(format.joints.size(), scale.value_or(1.0));
  } else {
    for (const double turn : counts) {
      format.joint_scale.push_back(2.0 * std::numbers::pi / turn);
    }
    if (counts.size() != format.joints.size()) {
      root.fail("counts_per_turn", fmt::format("{} counts per turn, expected one for each of {} joints", counts.size(),
                                               format.joints.size()));
    }
  }
  const std::string length = units.text_or("length", "mm");
  const auto scale = length_unit(length);
  if (!scale) {
    units.fail("length",
               fmt::format("{} is not a unit known for `length`, expected mm, um, m or in", in_quotes(length)));
  }
  format.length_scale = scale.value_or(1.0);
  const std::string time = units.text_or("time", "s");
  if (time != "s" && time != "ms" && time != "us") {
    units.fail("time", fmt::format("{} is not a unit known for `time`, expected s, ms or us", in_quotes(time)));
  }
  format.time_scale = time == "ms" ? 1e-3 : time == "us" ? 1e-6 : 1.0;
}

void check_columns(TomlTable& root, const StreamFormat& format) {
  std::vector<StreamField> all = format.joints;
  all.insert(all.end(), format.xyz.begin(), format.xyz.end());
  for (const StreamField& field : {format.button, format.time, format.temperature}) {
    if (!field.empty()) {
      all.push_back(field);
    }
  }
  for (const StreamField& field : all) {
    if (!format.is_json && !is_column(field)) {
      root.fail("joints",
                fmt::format("the field {} is no column, expected its number from 1 such as \"3\"", in_quotes(field)));
    }
  }
}

}  // namespace

Expected<StreamFormat> read_stream_format(const std::filesystem::path& path) {
  auto document = TomlDocument::read(path, schema);
  if (!document) {
    return tl::unexpected(document.error());
  }
  TomlTable& root = document->root();
  StreamFormat format;
  (void)root.text_or("name", "");
  (void)root.text_or("note", "");
  const std::string form = root.text("form");
  if (form != "json" && form != "columns") {
    root.fail("form", fmt::format("form is {}, expected \"json\" or \"columns\"", in_quotes(form)));
  }
  format.is_json = form == "json";
  if (!format.is_json) {
    format.prefix = root.text_or("prefix", "");
    const std::string delimiter = root.text_or("delimiter", ",");
    if (delimiter.size() != 1) {
      root.fail("delimiter", fmt::format("the delimiter is {}, expected one character", in_quotes(delimiter)));
    }
    format.delimiter = delimiter.empty() ? ',' : delimiter.front();
  }
  format.joints = root.texts("joints");
  if (format.joints.empty()) {
    root.fail("joints", "the stream names no joints, expected joints = [\"Angle1\", …]");
  }
  format.xyz = root.texts("xyz");
  if (!format.xyz.empty() && format.xyz.size() != 3) {
    root.fail("xyz", "xyz names the fields of three coordinates");
  }
  format.button = root.text_or("button", "");
  format.time = root.text_or("time", "");
  format.temperature = root.text_or("temperature", "");
  format.at_rest = read_condition(root, "at_rest");
  format.referenced = read_condition(root, "referenced");
  format.end_stop = read_condition(root, "no_end_stop");
  read_scales(root, format);
  check_columns(root, format);
  if (auto finished = document->finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  return format;
}

}  // namespace artcal
