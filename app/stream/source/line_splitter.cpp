#include "app/stream/source/line_splitter.h"

#include <algorithm>

#include "app/stream/stream_event.h"

namespace artcal {

LineSplitter::Taken LineSplitter::take(std::string& line) {
  const std::size_t end = bytes_.find('\n', std::max(begin_, searched_));
  if (end == std::string::npos) {
    bytes_.erase(0, begin_);
    begin_ = 0;
    if (bytes_.size() > max_event_bytes) {
      is_too_long_ = true;
      bytes_.clear();
    }
    searched_ = bytes_.size();
    return Taken::Nothing;
  }
  const bool is_too_long = is_too_long_ || end - begin_ > max_event_bytes;
  is_too_long_ = false;
  line.assign(bytes_, is_too_long ? end : begin_, is_too_long ? 0 : end - begin_);
  begin_ = searched_ = end + 1;
  return is_too_long ? Taken::TooLong : Taken::Line;
}

LineSplitter::Taken LineSplitter::take_rest(std::string& line) {
  line = bytes_.substr(begin_);
  const bool is_too_long = is_too_long_;
  *this = {};
  return is_too_long ? Taken::TooLong : line.empty() ? Taken::Nothing : Taken::Line;
}

}  // namespace artcal
