#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace artcal {

/// The lines of a text. Built in one pass; each question after that takes the logarithm of the number of lines.
class LineIndex {
 public:
  explicit LineIndex(std::string_view text);

  /// The line, from 1, of the byte at `offset`; an offset beyond the end is in the last line.
  [[nodiscard]] int line_at(std::size_t offset) const;

 private:
  std::vector<std::size_t> ends_;  // offsets of the line ends, ascending
};

}  // namespace artcal
