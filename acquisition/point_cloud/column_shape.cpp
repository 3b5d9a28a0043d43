#include "acquisition/point_cloud/column_shape.h"

#include <cmath>

#include <fmt/format.h>

namespace artcal {
namespace {

bool is_whole(double value) { return value == std::round(value); }

// Rows from which an order is hardly chance: one in sixty of five, and one in twelve of four.
constexpr std::size_t telling_rows = 5;
constexpr std::size_t min_rows = 3;

}  // namespace

void ColumnShape::add(const double* record) {
  const double x = record[0];
  if (!std::isfinite(x) || !std::isfinite(record[1]) || !std::isfinite(record[2])) {
    return;
  }
  if (rows_ == 0) {
    first_ = x;
  } else {
    counts_ = counts_ && x - last_ == 1.0;
    grows_ = grows_ && x >= last_;
    falls_ = falls_ && x <= last_;
  }
  whole_ = whole_ && is_whole(x);
  rows_with_fractions_ += is_whole(record[1]) && is_whole(record[2]) ? 0 : 1;
  last_ = x;
  ++rows_;
}

std::optional<std::string> ColumnShape::objection() const {
  const bool constant = grows_ && falls_;
  if (rows_ < min_rows || constant) {
    return std::nullopt;
  }
  if (whole_ && counts_) {
    return fmt::format("column 1 counts from {} to {}, as running numbers do", first_, last_);
  }
  if (whole_ && 2 * rows_with_fractions_ >= rows_) {
    return "column 1 holds whole numbers beside columns of fractions, as running numbers and labels do";
  }
  if (rows_ >= telling_rows && (grows_ || falls_)) {
    return fmt::format("column 1 only {} from row to row, as times and running numbers do", grows_ ? "grows" : "falls");
  }
  return std::nullopt;
}

std::optional<std::string> ColumnShape::doubt() const {
  if (objection() || rows_ < min_rows) {
    return std::nullopt;
  }
  if (grows_ && falls_ && whole_ && 2 * rows_with_fractions_ >= rows_) {
    return "column 1 is the same whole number in all rows, as labels are";
  }
  if (grows_ != falls_) {
    return fmt::format("column 1 only {} from row to row, as times do", grows_ ? "grows" : "falls");
  }
  return std::nullopt;
}

}  // namespace artcal
