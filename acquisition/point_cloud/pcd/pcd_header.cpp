#include "acquisition/point_cloud/pcd/pcd_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "acquisition/point_cloud/pcd/pcd_entries.h"
#include "core/text/decimal_number.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t largest_record = 65536;
constexpr std::size_t max_points = std::numeric_limits<int>::max();

Expected<std::size_t> whole_number(std::string_view word, std::string_view keyword, const std::string& where) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) {
    return bad_input(fmt::format("{}: found {}, expected a whole number", keyword, in_quotes(word)), where);
  }
  return static_cast<std::size_t>(value);
}

Expected<std::size_t> single_number(const PcdEntries& entries, std::string_view keyword) {
  const PcdEntry& entry = entries.at(keyword);
  if (entry.values.size() != 1) {
    return bad_input(fmt::format("{} has {} values, expected one", keyword, entry.values.size()), entry.where);
  }
  return whole_number(entry.values.front(), keyword, entry.where);
}

std::optional<NumberType> number_type(std::string_view type, std::string_view size) {
  static const std::map<std::pair<std::string_view, std::string_view>, NumberType> types{
      {{"I", "1"}, NumberType::Int8},   {{"U", "1"}, NumberType::UInt8},  {{"I", "2"}, NumberType::Int16},
      {{"U", "2"}, NumberType::UInt16}, {{"I", "4"}, NumberType::Int32},  {{"U", "4"}, NumberType::UInt32},
      {{"I", "8"}, NumberType::Int64},  {{"U", "8"}, NumberType::UInt64}, {{"F", "4"}, NumberType::Float32},
      {{"F", "8"}, NumberType::Float64}};
  const auto found = types.find({type, size});
  return found == types.end() ? std::nullopt : std::optional(found->second);
}

Expected<void> read_fields(const PcdEntries& entries, PcdHeader& header) {
  const std::string_view names = entries.contains("COLUMNS") ? "COLUMNS" : "FIELDS";
  const PcdEntry& entry = entries.at(names);
  for (const std::string_view keyword : {"SIZE", "TYPE", "COUNT"}) {
    if (entries.contains(keyword) && entries.at(keyword).values.size() != entry.values.size()) {
      return bad_input(fmt::format("{} has {} values for {} fields, expected one each", keyword,
                                   entries.at(keyword).values.size(), entry.values.size()),
                       entries.at(keyword).where);
    }
  }
  for (std::size_t i = 0; i < entry.values.size(); ++i) {
    PcdField field;
    field.name = entry.values[i];
    const std::string_view type = entries.at("TYPE").values[i];
    const std::string_view size = entries.at("SIZE").values[i];
    const auto known = number_type(type, size);
    if (!known) {
      return bad_input(
          fmt::format("the field {} has TYPE {} and SIZE {}, expected I or U of 1, 2, 4 or 8 bytes or F of "
                      "4 or 8",
                      in_quotes(field.name), in_quotes(type), in_quotes(size)),
          entries.at("TYPE").where);
    }
    field.type = *known;
    if (entries.contains("COUNT")) {
      const auto count = whole_number(entries.at("COUNT").values[i], "COUNT", entries.at("COUNT").where);
      if (!count) {
        return tl::unexpected(count.error());
      }
      field.count = *count;
    }
    // A field of COUNT 0, as drivers write it for padding, takes no bytes.
    if (field.count > largest_record) {
      return bad_input(fmt::format("the field {} has COUNT {}, expected 0 to {}", in_quotes(field.name), field.count,
                                   largest_record),
                       entries.at("COUNT").where);
    }
    field.offset = header.record_size;
    field.first_number = header.record_numbers;
    header.record_size += field.count * size_of(field.type);
    header.record_numbers += field.count;
    if (header.record_size > largest_record) {
      return bad_input(fmt::format("a point has more than {} bytes", largest_record), entry.where);
    }
    header.fields.push_back(std::move(field));
  }
  return {};
}

Expected<void> read_counts(const PcdEntries& entries, const std::string& path, PcdHeader& header) {
  if (!entries.contains("WIDTH") && !entries.contains("POINTS")) {
    return bad_input("the header says neither WIDTH nor POINTS, expected the number of points", path);
  }
  std::map<std::string_view, std::size_t> counts{{"WIDTH", 0}, {"HEIGHT", 1}, {"POINTS", 0}};
  for (auto& [keyword, count] : counts) {
    if (!entries.contains(keyword)) {
      continue;
    }
    const auto number = single_number(entries, keyword);
    if (!number) {
      return tl::unexpected(number.error());
    }
    if (*number > max_points) {
      return bad_input(fmt::format("{} is {}, expected at most {}", keyword, *number, max_points),
                       entries.at(keyword).where);
    }
    count = *number;
  }
  // Two numbers below 2^31 each: their product fits.
  const std::size_t by_size = counts["WIDTH"] * counts["HEIGHT"];
  header.points = entries.contains("POINTS") ? counts["POINTS"] : by_size;
  if (entries.contains("WIDTH") && by_size != header.points) {
    return bad_input(fmt::format("WIDTH times HEIGHT is {}, but POINTS is {}; the header contradicts itself", by_size,
                                 header.points),
                     entries.at("POINTS").where);
  }
  return {};
}

Expected<void> read_viewpoint(const PcdEntries& entries, PcdHeader& header) {
  if (!entries.contains("VIEWPOINT")) {
    return {};
  }
  const PcdEntry& entry = entries.at("VIEWPOINT");
  for (const std::string_view word : entry.values) {
    const auto value = decimal_number(word);
    if (!value) {
      break;
    }
    header.viewpoint.push_back(*value);
  }
  if (header.viewpoint.size() != 7 || entry.values.size() != 7) {
    return bad_input("VIEWPOINT: expected seven numbers, tx ty tz qw qx qy qz", entry.where);
  }
  return {};
}

Expected<void> read_data(const PcdEntries& entries, PcdHeader& header) {
  const PcdEntry& entry = entries.at("DATA");
  const std::string_view kind = entry.values.size() == 1 ? entry.values.front() : std::string_view{};
  if (kind != "ascii" && kind != "binary" && kind != "binary_compressed") {
    std::string found;
    for (const std::string_view word : entry.values) {
      found += (found.empty() ? "" : " ") + std::string(word);
    }
    return bad_input(fmt::format("DATA: found {}, expected ascii, binary or binary_compressed, and the first point "
                                 "after the end of this line",
                                 found.empty() ? "nothing" : in_quotes(found)),
                     entry.where);
  }
  header.data = kind == "ascii" ? PcdData::Ascii : kind == "binary" ? PcdData::Binary : PcdData::BinaryCompressed;
  return {};
}

Expected<void> check_version(const PcdEntries& entries) {
  if (!entries.contains("VERSION")) {
    return {};
  }
  const PcdEntry& entry = entries.at("VERSION");
  const std::string_view version = entry.values.size() == 1 ? entry.values.front() : std::string_view{};
  for (const std::string_view known : {".7", "0.7", ".6", "0.6", ".5", "0.5"}) {
    if (version == known) {
      return {};
    }
  }
  return bad_input(fmt::format("VERSION: found {}, expected 0.5, 0.6 or 0.7", in_quotes(version)), entry.where);
}

}  // namespace

Expected<PcdHeader> read_pcd_header(std::string_view bytes, const std::string& path) {
  const auto entries = read_pcd_entries(bytes, path);
  if (!entries) {
    return tl::unexpected(entries.error());
  }
  PcdHeader header;
  header.body = entries->body;
  header.lines = entries->lines;
  return check_version(*entries)
      .and_then([&] { return read_data(*entries, header); })
      .and_then([&] { return read_fields(*entries, header); })
      .and_then([&] { return read_counts(*entries, path, header); })
      .and_then([&] { return read_viewpoint(*entries, header); })
      .map([&] { return std::move(header); });
}

}  // namespace artcal
