#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace artcal {

/// Divides bytes as they arrive into lines. What it holds is bounded: of a line longer than max_event_bytes nothing is
/// kept but that it was there.
class LineSplitter {
 public:
  enum class Taken { Nothing, Line, TooLong };

  void add(std::string_view bytes) { bytes_ += bytes; }
  /// The next whole line, without its end.
  Taken take(std::string& line);
  /// After the last byte: what stands behind the last line end; it may have been cut off.
  Taken take_rest(std::string& line);

 private:
  std::string bytes_;
  std::size_t begin_ = 0;     // of what has not been taken
  std::size_t searched_ = 0;  // no line end before it
  bool is_too_long_ = false;  // the line that begins at begin_ had more bytes, which were dropped
};

}  // namespace artcal
