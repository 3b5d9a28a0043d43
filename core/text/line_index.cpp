#include "core/text/line_index.h"

#include <algorithm>

namespace artcal {

LineIndex::LineIndex(std::string_view text) {
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n', end + 1)) {
    ends_.push_back(end);
  }
}

int LineIndex::line_at(std::size_t offset) const {
  return 1 + static_cast<int>(std::lower_bound(ends_.begin(), ends_.end(), offset) - ends_.begin());
}

}  // namespace artcal
