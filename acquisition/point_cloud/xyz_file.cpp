#include "acquisition/point_cloud/xyz_file.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/point_cloud/cloud_builder.h"
#include "acquisition/point_cloud/column_shape.h"
#include "acquisition/point_cloud/text_rows.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t shortest_row = 6;  // "1 2 3\n"

// The first line decides: with a semicolon in it, semicolons separate, else with a comma commas. A decimal comma then
// shows as a field with a blank in it or as one column too many.
TextRows::Separator separator_of(std::string_view first_line) {
  return first_line.find(';') != std::string_view::npos   ? TextRows::Separator::Semicolon
         : first_line.find(',') != std::string_view::npos ? TextRows::Separator::Comma
                                                          : TextRows::Separator::Blanks;
}

std::string unquoted(std::string_view name) {
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"') {
    name = name.substr(1, name.size() - 2);
  }
  return std::string(name);
}

bool is_header(const TextRows& rows) {
  for (std::size_t i = 0; i < rows.fields().size(); ++i) {
    if (rows.is_number_at(i)) {
      return false;
    }
  }
  return true;
}

/// Reads a text from its first row to its last.
class XyzReader {
 public:
  XyzReader(const FileBytes& file, const CloudUnits& units, const TextColumns& stated)
      : file_(file),
        units_(units),
        stated_(stated),
        rows_(file.bytes, file.path.string(), 1, TextRows::Separator::Blanks) {}

  Expected<ReadCloud> read() {
    more_ = rows_.next();
    return take_count().and_then([&] { return take_header(); }).and_then([&] { return take_rows(); });
  }

 private:
  [[nodiscard]] std::string path() const { return file_.path.string(); }

  [[nodiscard]] bool is_row_of_numbers() const {
    bool all = rows_.fields().size() == width_;
    for (std::size_t i = 0; all && i < width_; ++i) {
      all = rows_.is_number_at(i);
    }
    return all;
  }

  // The path may lead to any file of this computer, whose content no message is to show.
  static tl::unexpected<Error> no_table(const std::string& where) {
    return bad_input(
        "this is no table of points: expected lines of numbers x y z, with a line of names above or without", where);
  }

  // A line of one whole number is the number of points that follow (PTS).
  Expected<void> take_count() {
    if (!more_) {
      return bad_input("the file holds no points", path());
    }
    const auto count = rows_.fields().size() == 1 ? whole_number(rows_.fields().front()) : std::nullopt;
    if (!count || promised_) {
      return {};
    }
    promised_ = count;
    count_where_ = rows_.where();
    more_ = rows_.next();
    if (!more_) {
      return bad_input(
          fmt::format("the line looks like the number of points of a PTS file, {}, but no points follow", *count),
          count_where_);
    }
    return {};
  }

  Expected<void> take_header() {
    rows_.separate_by(separator_of(rows_.line()));
    width_ = rows_.fields().size();
    columns_ = {0, 1, 2};
    if (!is_header(rows_)) {
      if (width_ < columns_.size()) {
        return bad_input(fmt::format("the line has {} {}, expected at least {}", width_,
                                     width_ == 1 ? "column" : "columns", columns_.size()),
                         rows_.where());
      }
      told_ = fmt::format("columns 1, 2, 3 of {}, without a header", width_);
      return take_stated_columns();
    }
    std::vector<std::string> names(width_);
    std::transform(rows_.fields().begin(), rows_.fields().end(), names.begin(), unquoted);
    has_header_ = true;
    if (!stated_) {
      auto found = find_cloud_columns(names, units_, rows_.where(), warnings_);
      if (!found) {
        return rows_.next() && is_row_of_numbers() ? tl::unexpected(found.error()) : no_table(found.error().where);
      }
      rows_.allow_quotes();
      columns_ = std::move(*found);
      told_ = fmt::format("columns {}, {}, {} of {}, named x, y, z by the header", columns_[0] + 1, columns_[1] + 1,
                          columns_[2] + 1, width_);
    }
    more_ = rows_.next();
    return take_stated_columns().and_then([&]() -> Expected<void> { return more_ ? take_count() : Expected<void>{}; });
  }

  Expected<void> take_stated_columns() {
    if (!stated_) {
      return {};
    }
    const auto& stated = *stated_;
    for (std::size_t i = 0; i < stated.size(); ++i) {
      if (stated[i] < 1 || static_cast<std::size_t>(stated[i]) > width_) {
        return bad_input(
            fmt::format("the line has {} columns, but column {} is stated to be a coordinate", width_, stated[i]),
            rows_.where());
      }
      columns_[i] = static_cast<std::size_t>(stated[i] - 1);
    }
    told_ = fmt::format("columns {} of {}, as stated", fmt::join(stated, ", "), width_);
    return {};
  }

  Expected<ReadCloud> take_rows() {
    const auto lines = static_cast<std::size_t>(std::count(file_.bytes.begin(), file_.bytes.end(), '\n')) + 1;
    CloudBuilder builder(units_, columns_.size(), std::min(lines, file_.bytes.size() / shortest_row + 1));
    std::vector<double> record(columns_.size());
    ColumnShape shape;
    for (; more_; more_ = rows_.next()) {
      if (takes_next_block()) {
        continue;
      }
      if (auto read = take_row(record); !read) {
        return tl::unexpected(read.error());
      }
      shape.add(record.data());
      builder.add(record.data());
      take_many_rows(shape, builder);
    }
    if (promised_ && *promised_ != read_) {
      return bad_input(fmt::format("the line promises {} points, {} follow; is the file truncated?", *promised_, read_),
                       count_where_);
    }
    const auto end = rows_.check_end();
    if (!end) {
      return tl::unexpected(end.error());
    }
    warnings_.insert(warnings_.end(), end->begin(), end->end());
    auto looked_at = look_at(shape);
    if (!looked_at) {
      return tl::unexpected(looked_at.error());
    }
    return std::move(builder).finish(file_, std::move(warnings_)).map([&](PointCloud&& cloud) {
      return ReadCloud{std::move(cloud), told_};
    });
  }

  void take_many_rows(ColumnShape& shape, CloudBuilder& builder) {
    const auto next = [&] {
      const std::size_t max_rows = promised_ ? *promised_ - std::min(*promised_, read_) : file_.bytes.size();
      return rows_.take_many(columns_, width_, max_rows);
    };
    for (auto numbers = next(); !numbers.empty(); numbers = next()) {
      const std::size_t count = numbers.size() / columns_.size();
      for (std::size_t i = 0; i < count; ++i) {
        shape.add(numbers.data() + i * columns_.size());
      }
      builder.add(numbers.data(), count);
      read_ += count;
    }
  }

  // A PTS of several scans: the next count where the points of the last one are through.
  bool takes_next_block() {
    if (!promised_ || read_ != *promised_ || rows_.fields().size() != 1 || width_ == 1) {
      return false;
    }
    const auto next = whole_number(rows_.fields().front());
    promised_ = next ? *promised_ + *next : *promised_;
    return next.has_value();
  }

  Expected<void> take_row(std::vector<double>& record) {
    if (rows_.fields().size() != width_) {
      return bad_input(
          fmt::format("the line has {} columns, expected {} as in the lines before", rows_.fields().size(), width_),
          rows_.where());
    }
    ++read_;
    auto read = rows_.numbers(columns_, record.data());
    if (!read && read_ == 1 && !has_header_ && !stated_ && width_ > 3 && !rows_.is_number_at(0)) {
      return bad_input(read.error().message +
                           "; is it a label? Then state the columns of x, y and z, such as --columns "
                           "2,3,4",
                       read.error().where);
    }
    return read;
  }

  Expected<void> look_at(const ColumnShape& shape) {
    if (has_header_ || stated_) {
      return {};
    }
    if (const auto objection = width_ > 3 ? shape.objection() : std::nullopt) {
      return bad_input(
          fmt::format("there are {} columns without a header, and {}: state those of x, y and z, such as --columns "
                      "2,3,4, or 1,2,3 if the first one is x, or name the columns in a first line",
                      width_, *objection),
          path());
    }
    if (const auto doubt = width_ > 3 ? shape.doubt() : std::nullopt) {
      warnings_.push_back(fmt::format("{}, but was taken for x; state other columns if it is none", *doubt));
    }
    return {};
  }

  const FileBytes& file_;
  const CloudUnits& units_;
  const TextColumns& stated_;
  TextRows rows_;
  bool more_ = false;
  bool has_header_ = false;
  std::size_t width_ = 0;
  CloudColumns columns_;
  std::string told_;
  std::optional<std::size_t> promised_;  // points
  std::string count_where_;
  std::size_t read_ = 0;
  std::vector<std::string> warnings_;
};

}  // namespace

Expected<ReadCloud> parse_xyz(const FileBytes& file, const CloudUnits& units, const TextColumns& columns) {
  return XyzReader(file, units, columns).read();
}

}  // namespace artcal
