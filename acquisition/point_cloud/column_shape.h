#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace artcal {

/// Looks at what a text without a header has in its first column, which is taken for x only by custom: programs write
/// running numbers, labels and times there. Takes the numbers of three columns row by row, in the file's unit.
class ColumnShape {
 public:
  void add(const double* record);

  /// Why the first column is no coordinate, as far as its numbers show: it counts, holds whole numbers beside
  /// fractions, or only grows or falls. Nothing where it may be x.
  [[nodiscard]] std::optional<std::string> objection() const;
  /// The same where too few rows tell, or the column never changes: something to be looked at.
  [[nodiscard]] std::optional<std::string> doubt() const;

 private:
  std::size_t rows_ = 0;
  std::size_t rows_with_fractions_ = 0;  // in the second or third column
  bool whole_ = true, counts_ = true;
  bool grows_ = true, falls_ = true;  // or stays
  double first_ = 0.0, last_ = 0.0;
};

}  // namespace artcal
