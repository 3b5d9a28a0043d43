#include "acquisition/import/imported_readings.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/csv/csv_text.h"
#include "acquisition/import/column_roles.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

bool is_header(const std::vector<std::string>& fields) {
  bool comma = false, point = false;
  return std::none_of(fields.begin(), fields.end(),
                      [&](const std::string& field) { return number_text(field, comma, point).has_value(); });
}

Expected<std::vector<ColumnRole>> roles_of(const TextFile& file, const DelimitedText& table, const TextImport& options,
                                           bool has_header) {
  const DelimitedRow& first = table.rows.front();
  if (!options.columns.empty()) {
    return stated_roles(options.columns, first.fields);
  }
  const std::string where = fmt::format("{}:{}", file.path.string(), first.line);
  if (!has_header) {
    return bad_input(
        fmt::format("the table has no header, and what its {} columns hold is not known; say it, such as --columns "
                    "name,x,y,z (- passes over a column)",
                    first.fields.size()),
        where);
  }
  return roles_of_header(first.fields, where);
}

std::string used_text(const std::vector<ColumnRole>& roles, const DelimitedText& table, bool has_header) {
  std::vector<std::string> used, passed;
  for (const ColumnRole& each : roles) {
    used.push_back(fmt::format("{} = column {}", each.role, each.column + 1));
  }
  const std::vector<std::string>& first = table.rows.front().fields;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (std::none_of(roles.begin(), roles.end(), [&](const ColumnRole& each) { return each.column == i; })) {
      passed.push_back(has_header ? in_quotes(first[i]) : fmt::format("{}", i + 1));
    }
  }
  return fmt::format("{}{}", fmt::join(used, ", "),
                     passed.empty() ? "" : fmt::format("; passed over: {}", fmt::join(passed, ", ")));
}

// 1, 2, 3 … or 0, 1, 2 …
bool counts_rows(const std::vector<std::vector<std::string>>& rows, std::size_t column) {
  if (rows.size() < 3) {
    return false;
  }
  const double first = std::strtod(rows.front()[column].c_str(), nullptr);
  double expected = first;
  return (first == 0.0 || first == 1.0) && std::all_of(rows.begin(), rows.end(), [&](const auto& row) {
           return std::strtod(row[column].c_str(), nullptr) == expected++;
         });
}

}  // namespace

Expected<ImportedReadings> import_text(const TextFile& file, const TextImport& options) {
  const auto table = split_text(file, options.delimiter, options.skipped);
  if (!table) {
    return tl::unexpected(table.error());
  }
  const bool has_header = is_header(table->rows.front().fields);
  const auto roles = roles_of(file, *table, options, has_header);
  if (!roles) {
    return tl::unexpected(roles.error());
  }
  ImportedReadings readings;
  for (const ColumnRole& each : *roles) {
    readings.columns.push_back(each.role);
  }
  bool comma = false, point = false;
  for (std::size_t i = has_header ? 1 : 0; i < table->rows.size(); ++i) {
    const DelimitedRow& row = table->rows[i];
    std::vector<std::string>& fields = readings.rows.emplace_back();
    for (const ColumnRole& each : *roles) {
      const std::string& field = row.fields[each.column];
      const std::string where = fmt::format("{}:{}:{}", file.path.string(), row.line, row.columns[each.column]);
      if (is_label(each.role)) {
        if (find_control(field)) {
          return bad_input(fmt::format("the name for `{}` has a control character", each.role), where);
        }
        fields.push_back(field);
        continue;
      }
      const auto number = number_text(field, comma, point);
      if (!number) {
        return bad_input(fmt::format("`{}` is {}, expected a number", each.role, in_quotes(field)), where);
      }
      if (comma && point) {
        return bad_input(
            fmt::format("{} and numbers above have decimal commas and decimal points in one file", in_quotes(field)),
            where);
      }
      fields.push_back(*number);
    }
  }
  if (readings.rows.empty()) {
    return bad_input("the file holds a header and no rows", file.path.string());
  }
  const auto x = std::find(readings.columns.begin(), readings.columns.end(), "x");
  if (x != readings.columns.end() &&
      counts_rows(readings.rows, static_cast<std::size_t>(x - readings.columns.begin()))) {
    return bad_input(
        fmt::format("the column taken for x counts the rows from {}; say which columns hold the coordinates, "
                    "such as --columns -,x,y,z",
                    readings.rows.front()[static_cast<std::size_t>(x - readings.columns.begin())]),
        fmt::format("{}:{}", file.path.string(), table->rows[has_header ? 1 : 0].line));
  }
  readings.format = fmt::format("text separated by {}, {} header, {}", name_of(table->delimiter),
                                has_header ? "a" : "no", comma ? "decimal commas" : "decimal points");
  readings.understood = {used_text(*roles, *table, has_header)};
  return readings;
}

std::string readings_csv(const ImportedReadings& readings) {
  std::string text = fmt::format("{}\n", fmt::join(readings.columns, ","));
  for (const auto& row : readings.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += (i == 0 ? "" : ",") + (is_label(readings.columns[i]) ? csv_field(row[i]) : row[i]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace artcal
