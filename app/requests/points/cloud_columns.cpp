#include "app/requests/points/cloud_columns.h"

#include <algorithm>

namespace artcal {

void add_columns_option(CLI::App& parser, std::vector<int>& columns) {
  parser
      .add_option("--columns", columns,
                  "text: which columns are x, y and z, counted from 1, such as 2,3,4; by default from the header, or "
                  "the first three")
      ->delimiter(',')
      ->type_name("X,Y,Z");
}

Expected<TextColumns> cloud_columns(const std::vector<int>& columns) {
  if (columns.empty()) {
    return TextColumns();
  }
  const bool from_one = std::all_of(columns.begin(), columns.end(), [](int column) { return column >= 1; });
  if (columns.size() != 3 || !from_one || columns[0] == columns[1] || columns[1] == columns[2] ||
      columns[0] == columns[2]) {
    return wrong_usage("--columns: expected three different columns, counted from 1, such as 2,3,4");
  }
  return TextColumns({columns[0], columns[1], columns[2]});
}

}  // namespace artcal
