#include "app/requests/points/row_list.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "core/files/size_limits.h"
#include "core/files/text_file.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

/// Which column of the cloud each listed row is; -1 is not listed.
Expected<std::vector<Eigen::Index>> columns_of(const PointCloud& cloud, const TextFile& file) {
  const std::string path = file.path.string();
  std::vector<Eigen::Index> columns;
  std::string_view rest = file.text;
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = rest.find('\n');
    std::string_view word = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    word.remove_prefix(std::min(word.find_first_not_of(" \t\r"), word.size()));
    word.remove_suffix(word.size() - word.find_last_not_of(" \t\r") - 1);  // npos + 1 is 0: all blank
    if (word.empty() || word.front() == '#') {
      continue;
    }
    const std::string where = fmt::format("{}:{}", path, line);
    int row = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), row);
    if (error != std::errc{} || stop != word.data() + word.size() || row < 0) {
      return bad_input(fmt::format("found {}, expected the number of a row, from 0", in_quotes(word)), where);
    }
    const auto found = std::lower_bound(cloud.rows.begin(), cloud.rows.end(), row);
    if (found == cloud.rows.end() || *found != row) {
      return bad_input(fmt::format("row {} is not among the {} points of {}, or was dropped because it is not a number",
                                   row, cloud.rows.size(), cloud.input.path),
                       where);
    }
    columns.push_back(found - cloud.rows.begin());
  }
  if (columns.empty()) {
    return bad_input("the list names no row", path);
  }
  std::sort(columns.begin(), columns.end());
  const auto twice = std::adjacent_find(columns.begin(), columns.end());
  if (twice != columns.end()) {
    return bad_input(fmt::format("row {} is listed twice", cloud.rows[static_cast<std::size_t>(*twice)]), path);
  }
  return columns;
}

}  // namespace

Expected<PointCloud> take_rows(const PointCloud& cloud, const std::filesystem::path& list,
                               std::vector<InputFile>& inputs) {
  const auto file = read_text_file(list, largest::row_list);
  if (!file) {
    return tl::unexpected(file.error());
  }
  const auto columns = columns_of(cloud, *file);
  if (!columns) {
    return tl::unexpected(columns.error());
  }
  inputs.push_back({list.string(), file->sha256});
  PointCloud taken;
  taken.points = cloud.points(Eigen::all, *columns);
  if (cloud.joints.size() > 0) {
    taken.joints = cloud.joints(Eigen::all, *columns);
  }
  for (const Eigen::Index column : *columns) {
    taken.rows.push_back(cloud.rows[static_cast<std::size_t>(column)]);
  }
  taken.dropped = cloud.dropped;
  taken.input = cloud.input;
  taken.warnings = cloud.warnings;
  return taken;
}

}  // namespace artcal
