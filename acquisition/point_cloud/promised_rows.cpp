#include "acquisition/point_cloud/promised_rows.h"

#include <fmt/format.h>

namespace artcal {

Expected<std::size_t> take_promised_rows(TextRows& rows, const CloudColumns& columns, std::size_t width,
                                         std::size_t count, CloudBuilder& builder) {
  std::vector<double> record(columns.size());
  std::size_t taken = 0;
  while (taken < count) {
    if (const auto many = rows.take_many(columns, width, count - taken); !many.empty()) {
      builder.add(many.data(), many.size() / columns.size());
      taken += many.size() / columns.size();
      continue;
    }
    if (!rows.next()) {
      break;
    }
    if (rows.fields().size() != width) {
      return bad_input(
          fmt::format("the line has {} numbers, expected {} as the header says", rows.fields().size(), width),
          rows.where());
    }
    if (auto read = rows.numbers(columns, record.data()); !read) {
      return tl::unexpected(read.error());
    }
    builder.add(record.data());
    ++taken;
  }
  return taken;
}

}  // namespace artcal
