#include "acquisition/point_cloud/pcd/pcd_entries.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "acquisition/point_cloud/text_rows.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::array<std::string_view, 11> keywords{"VERSION", "FIELDS", "COLUMNS",   "SIZE",   "TYPE", "COUNT",
                                                    "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
constexpr std::size_t longest_line = 65536;

using Words = std::vector<std::string_view>;

}  // namespace

bool looks_like_pcd(std::string_view bytes) {
  std::size_t start = 0;
  while (start < bytes.size() && start < longest_line) {
    const std::size_t end = std::min(bytes.substr(0, longest_line).find('\n', start), bytes.size());
    const Words words = words_of(bytes.substr(start, end - start));
    if (!words.empty() && !words.front().starts_with('#')) {
      return std::find(keywords.begin(), keywords.end(), words.front()) != keywords.end();
    }
    start = end + 1;
  }
  return false;
}

Expected<PcdEntries> read_pcd_entries(std::string_view bytes, const std::string& path) {
  PcdEntries entries;
  std::size_t start = 0;
  while (start < bytes.size() && !entries.contains("DATA")) {
    const std::size_t end = bytes.substr(start, longest_line).find('\n');
    const std::string where = fmt::format("{}:{}", path, ++entries.lines);
    if (end == std::string_view::npos && bytes.size() - start > longest_line) {
      return bad_input("a line of the header does not end, expected PCD", where);
    }
    const std::string_view line = bytes.substr(start, end);
    start = end == std::string_view::npos ? bytes.size() : start + end + 1;
    Words words = words_of(line);
    if (words.empty() || words.front().starts_with('#')) {
      continue;
    }
    const std::string_view keyword = words.front();
    if (std::find(keywords.begin(), keywords.end(), keyword) == keywords.end()) {
      return bad_input(fmt::format("found {}, expected a line of a PCD header such as FIELDS, SIZE, TYPE or DATA",
                                   in_quotes(keyword)),
                       where);
    }
    words.erase(words.begin());
    if (!entries.by_keyword.emplace(keyword, PcdEntry{std::move(words), where}).second) {
      return bad_input(fmt::format("{} is there twice", keyword), where);
    }
  }
  entries.body = start;
  for (const std::string_view keyword : {"SIZE", "TYPE", "DATA"}) {
    if (!entries.contains(keyword)) {
      return bad_input(fmt::format("the header has no line {}", keyword), path);
    }
  }
  if (entries.contains("FIELDS") == entries.contains("COLUMNS")) {
    return bad_input("expected one line FIELDS (or COLUMNS) that names what a point has", path);
  }
  return entries;
}

}  // namespace artcal
