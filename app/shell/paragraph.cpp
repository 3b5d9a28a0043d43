#include "app/shell/paragraph.h"

#include <algorithm>

#include "core/text/in_quotes.h"

namespace artcal {

std::string filled(std::string_view text, std::size_t width, std::size_t indent, std::size_t column) {
  std::string lines;
  bool is_first = true;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string_view word = text.substr(at, end - at);
    at = end + 1;
    if (word.empty()) {
      continue;
    }
    const std::size_t length = character_count(word);
    if (!is_first && column + 1 + length > width) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!is_first) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += length;
    is_first = false;
  }
  return lines;
}

}  // namespace artcal
