#include <algorithm>

#include <fmt/format.h>

#include "acquisition/cloud_builder.h"
#include "acquisition/cloud_formats.h"
#include "acquisition/text_rows.h"
#include "core/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t shortest_row = 6;  // "1 2 3\n"

// The first line decides: with a comma in it, commas separate, and a decimal comma then shows as a field
// with a blank in it or as one column too many.
Expected<TextRows::Separator> separator_of(const TextRows& first) {
  if (first.line().find(';') != std::string_view::npos) {
    return bad_input(
        "the columns are separated by semicolons, expected blanks, tabs or commas (and a point in numbers)",
        first.where());
  }
  return first.line().find(',') != std::string_view::npos ? TextRows::Separator::Comma : TextRows::Separator::Blanks;
}

std::string unquoted(std::string_view name) {
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"') {
    name = name.substr(1, name.size() - 2);
  }
  return std::string(name);
}

bool is_header(const TextRows& rows) { return std::none_of(rows.fields().begin(), rows.fields().end(), is_number); }

}  // namespace

Expected<PointCloud> parse_xyz(const FileBytes& file, const CloudUnits& units) {
  const std::string path = file.path.string();
  TextRows rows(file.bytes, path, 1, TextRows::Separator::Blanks);
  if (!rows.next()) {
    return bad_input("the file holds no points", path);
  }
  const auto separator = separator_of(rows);
  if (!separator) {
    return tl::unexpected(separator.error());
  }
  rows = TextRows(file.bytes, path, 1, *separator);
  rows.next();
  const std::size_t width = rows.fields().size();
  CloudColumns columns{0, 1, 2};
  std::vector<std::string> warnings;
  bool more = true;
  if (is_header(rows)) {
    std::vector<std::string> names(width);
    std::transform(rows.fields().begin(), rows.fields().end(), names.begin(), unquoted);
    auto found = find_cloud_columns(names, units, rows.where(), warnings);
    if (!found) {
      return tl::unexpected(found.error());
    }
    columns = *found;
    more = rows.next();
  }
  const auto lines = static_cast<std::size_t>(std::count(file.bytes.begin(), file.bytes.end(), '\n')) + 1;
  CloudBuilder builder(units, columns.size(), std::min(lines, file.bytes.size() / shortest_row + 1));
  std::vector<double> record(columns.size());
  for (; more; more = rows.next()) {
    if (rows.fields().size() != width) {
      return bad_input(
          fmt::format("the line has {} columns, expected {} as in the lines before", rows.fields().size(), width),
          rows.where());
    }
    if (auto read = rows.numbers(columns, record.data()); !read) {
      return tl::unexpected(read.error());
    }
    builder.add(record.data());
  }
  return std::move(builder).finish(file, std::move(warnings));
}

}  // namespace artcal
