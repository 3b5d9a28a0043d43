#include "acquisition/point_cloud/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "acquisition/point_cloud/text_rows.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t longest_header_line = 65536;
constexpr std::size_t max_properties = 4096;
constexpr std::size_t max_records = std::numeric_limits<int>::max();

using Words = std::vector<std::string_view>;

std::optional<NumberType> number_type(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, NumberType>, 16> types{{{"char", NumberType::Int8},
                                                                                  {"int8", NumberType::Int8},
                                                                                  {"uchar", NumberType::UInt8},
                                                                                  {"uint8", NumberType::UInt8},
                                                                                  {"short", NumberType::Int16},
                                                                                  {"int16", NumberType::Int16},
                                                                                  {"ushort", NumberType::UInt16},
                                                                                  {"uint16", NumberType::UInt16},
                                                                                  {"int", NumberType::Int32},
                                                                                  {"int32", NumberType::Int32},
                                                                                  {"uint", NumberType::UInt32},
                                                                                  {"uint32", NumberType::UInt32},
                                                                                  {"float", NumberType::Float32},
                                                                                  {"float32", NumberType::Float32},
                                                                                  {"double", NumberType::Float64},
                                                                                  {"float64", NumberType::Float64}}};
  const auto* const found = std::find_if(types.begin(), types.end(), [&](const auto& t) { return t.first == name; });
  return found == types.end() ? std::nullopt : std::optional(found->second);
}

/// Reads line by line; `where` is the line at hand.
class Reader {
 public:
  Reader(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  Expected<PlyHeader> read() {
    bool formatted = false;
    for (bool first = true;; first = false) {
      const auto words = next_line();
      if (!words) {
        return tl::unexpected(words.error());
      }
      if (first || words->empty() || words->front() == "comment" || words->front() == "obj_info") {
        continue;  // the first line is the "ply" that brought us here
      }
      if (words->front() == "end_header") {
        if (words->size() > 1) {
          return bad_input("end_header: expected nothing behind it, and the first point on a line of its own", where_);
        }
        break;
      }
      if (words->front() == "format" && formatted) {
        return bad_input("format is there twice", where_);
      }
      formatted = formatted || words->front() == "format";
      if (auto taken = take(*words); !taken) {
        return tl::unexpected(taken.error());
      }
    }
    if (!formatted) {
      return bad_input("the header has no line that says the format, such as: format ascii 1.0", path_);
    }
    header_.body = at_;
    return std::move(header_);
  }

 private:
  Expected<Words> next_line() {
    where_ = fmt::format("{}:{}", path_, ++header_.lines);
    const std::size_t end = bytes_.substr(at_, longest_header_line).find('\n');
    if (end == std::string_view::npos) {
      return bad_input("the header ends without a line end_header; is the file truncated?", where_);
    }
    Words words = words_of(bytes_.substr(at_, end));
    at_ += end + 1;
    return words;
  }

  Expected<void> take(const Words& words) {
    if (words.front() == "format") {
      return take_format(words);
    }
    if (words.front() == "element") {
      return take_element(words);
    }
    if (words.front() == "property") {
      return take_property(words);
    }
    return bad_input(fmt::format("found {}, expected a line of a PLY header: format, comment, element, property or "
                                 "end_header, alone on its line",
                                 in_quotes(words.front())),
                     where_);
  }

  Expected<void> take_format(const Words& words) {
    const std::string_view kind = words.size() == 3 && words[2] == "1.0" ? words[1] : std::string_view{};
    if (kind != "ascii" && kind != "binary_little_endian" && kind != "binary_big_endian") {
      return bad_input("format: expected ascii, binary_little_endian or binary_big_endian, then 1.0", where_);
    }
    header_.data = kind == "ascii"                  ? PlyData::Ascii
                   : kind == "binary_little_endian" ? PlyData::LittleEndian
                                                    : PlyData::BigEndian;
    return {};
  }

  Expected<void> take_element(const Words& words) {
    std::uint64_t count = 0;
    if (words.size() == 3) {
      const auto [end, error] = std::from_chars(words[2].data(), words[2].data() + words[2].size(), count);
      if (error == std::errc{} && end == words[2].data() + words[2].size() && count <= max_records) {
        header_.elements.push_back({std::string(words[1]), static_cast<std::size_t>(count), {}});
        return {};
      }
    }
    return bad_input(fmt::format("expected element, a name and a whole number up to {}", max_records), where_);
  }

  Expected<void> take_property(const Words& words) {
    const bool list = words.size() == 5 && words[1] == "list";
    const auto type = list || words.size() == 3 ? number_type(words[words.size() - 2]) : std::nullopt;
    const auto length = list ? number_type(words[2]) : std::nullopt;
    if (!type || (list && (!length || *length == NumberType::Float32 || *length == NumberType::Float64))) {
      return bad_input(
          "expected property, a type such as float or double, and a name; or property list, the type of "
          "the length (a whole number), that of the items, and a name",
          where_);
    }
    if (header_.elements.empty() || header_.elements.back().properties.size() == max_properties) {
      return bad_input(header_.elements.empty() ? "a property without an element before it" : "too many properties",
                       where_);
    }
    header_.elements.back().properties.push_back({std::string(words.back()), *type, length});
    return {};
  }

  std::string_view bytes_;
  const std::string& path_;
  std::string where_;
  std::size_t at_ = 0;
  PlyHeader header_;
};

}  // namespace

bool PlyElement::has_lists() const {
  return std::any_of(properties.begin(), properties.end(), [](const auto& p) { return p.length.has_value(); });
}

std::size_t PlyElement::record_size() const {
  std::size_t size = 0;
  for (const PlyProperty& property : properties) {
    size += size_of(property.type);
  }
  return size;
}

bool looks_like_ply(std::string_view bytes) { return bytes.starts_with("ply\n") || bytes.starts_with("ply\r\n"); }

Expected<PlyHeader> read_ply_header(std::string_view bytes, const std::string& path) {
  return Reader(bytes, path).read();
}

}  // namespace artcal
