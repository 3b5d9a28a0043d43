#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace artcal {

/// How many digits a number is written with.
struct WrittenDigits {
  std::size_t all = 0;       ///< of the mantissa
  std::size_t decimals = 0;  ///< of the mantissa, behind the point
  std::size_t exponent = 0;
};

/// Detects a table whose text was cut off in its last number. Only a text that does not end with a line end can be one;
/// the number that stands there is then compared with the numbers above it.
class CutOffWatch {
 public:
  /// `text` is the whole text of the table.
  explicit CutOffWatch(std::string_view text) : watches_(!text.empty() && text.back() != '\n' && text.back() != '\r') {}

  /// Whether rows need to be shown to it at all.
  [[nodiscard]] bool watches() const { return watches_; }

  /// The last field of each row in turn. `is_open`: the text ends within this field.
  void row(std::string_view last_field, bool is_open) {
    if (watches_) {
      note(last_field, is_open);
    }
  }

  /// REQUIRES: called after the last row, which is at `where`. Refused: a last number with fewer digits than every
  /// other in its column. A warning where the text ends within its last field and the number may be whole.
  [[nodiscard]] Expected<std::vector<std::string>> judge(const std::string& where) const;

 private:
  void note(std::string_view last_field, bool is_open);

  bool watches_;
  bool is_open_ = false;
  std::string last_;
  std::size_t numbers_above_ = 0;
  WrittenDigits fewest_{std::numeric_limits<std::size_t>::max(), std::numeric_limits<std::size_t>::max(),
                        std::numeric_limits<std::size_t>::max()};
};

}  // namespace artcal
