#include "app/stream/stream_format.h"

#include <cctype>
#include <numbers>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "core/toml/toml_document.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr std::string_view stream_schema = "artcal-stream/1";

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
    format.has_counts = true;
    for (const double turn : counts) {
      if (turn == 0.0) {
        root.fail("counts_per_turn",
                  "a joint has 0 counts per turn; expected a number such as 8192, or below zero "
                  "where it counts backwards");
      }
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
  for (const auto& condition : {format.at_rest, format.referenced, format.end_stop}) {
    if (condition) {
      all.push_back(condition->field);
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
  auto document = TomlDocument::read(path, stream_schema);
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
  const std::string within = root.text_or("at_rest_within", "");
  const auto angle = angle_quantity(within);
  if (!within.empty() && (!angle || !(*angle > 0.0))) {
    root.fail(
        "at_rest_within",
        fmt::format("at_rest_within is {}, expected an angle with its unit such as \"0.02 deg\"", in_quotes(within)));
  }
  format.at_rest_within = angle.value_or(0.0);
  format.max_rate = root.number_or("max_rate", format.max_rate);
  if (!(format.max_rate > 0.0)) {
    root.fail("max_rate", fmt::format("max_rate is {}, expected readings a second such as 20", format.max_rate));
  }
  read_scales(root, format);
  check_columns(root, format);
  if (auto finished = document->finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  return format;
}

Expected<StreamFormat> for_arm(StreamFormat format, const Arm& arm, const std::filesystem::path& path) {
  if (format.joints.size() != arm.joints.size()) {
    return bad_input(fmt::format("the stream has {} joints, the arm {} has {}; name the field of each in `joints`",
                                 format.joints.size(), in_quotes(arm.name), arm.joints.size()),
                     path.string());
  }
  for (std::size_t j = 0; j < arm.joints.size(); ++j) {
    if (arm.joints[j].is_prismatic() && format.has_counts) {
      return bad_input(
          fmt::format("joint {} of the arm is prismatic, and counts per turn say nothing of its travel; hand "
                      "its length on instead of counts",
                      j + 1),
          path.string());
    }
    if (arm.joints[j].is_prismatic()) {
      format.joint_scale[j] = format.length_scale;
    }
  }
  return format;
}

}  // namespace artcal
