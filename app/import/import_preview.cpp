#include "app/import/import_preview.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include <fmt/format.h>

#include "acquisition/import/column_roles.h"
#include "app/output/phrases.h"
#include "app/output/table.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t shown_rows = 3;

std::string range_text(const ImportedReadings& readings, std::size_t column) {
  if (is_label(readings.columns[column])) {
    std::set<std::string> names;
    for (const auto& row : readings.rows) {
      names.insert(row[column]);
    }
    return plural(names.size(), "name");
  }
  const auto value = [&](const std::vector<std::string>& row) { return std::strtod(row[column].c_str(), nullptr); };
  const auto [low, high] =
      std::minmax_element(readings.rows.begin(), readings.rows.end(),
                          [&](const auto& one, const auto& other) { return value(one) < value(other); });
  return fmt::format("{} to {}", (*low)[column], (*high)[column]);
}

}  // namespace

std::string import_preview(const std::string& path, const ImportedReadings& readings) {
  std::string text = fmt::format("{}: {}, {}\n", path, readings.format, plural(readings.rows.size(), "reading"));
  for (const std::string& each : readings.understood) {
    text += fmt::format("  {}\n", each);
  }
  Table table({"column", "row 1", "row 2", "row 3", "range"});
  for (std::size_t i = 0; i < readings.columns.size(); ++i) {
    std::vector<std::string> line{readings.columns[i]};
    for (std::size_t k = 0; k < shown_rows; ++k) {
      line.push_back(k < readings.rows.size() ? truncated(20, readings.rows[k][i]) : "");
    }
    line.push_back(range_text(readings, i));
    table.add(line);
  }
  return text + table.text();
}

}  // namespace artcal
