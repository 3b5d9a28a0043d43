#include "core/toml/toml_keys.h"

#include <algorithm>
#include <string>

namespace artcal {
namespace {

constexpr int max_key_parts = 32;

// The last byte of the TOML string that begins at `begin`.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const std::string three(3, quote);
  const bool is_long = text.substr(begin, 3) == three;
  for (std::size_t i = begin + (is_long ? 3 : 1); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (is_long && text.substr(i, 3) == three) {
      // Its last two characters may be quotes as well; a longer run is the next string's.
      std::size_t last = i + 2;
      while (last < i + 4 && last + 1 < text.size() && text[last + 1] == quote) {
        ++last;
      }
      return last;
    } else if (!is_long && (text[i] == quote || text[i] == '\n')) {
      return i;
    }
  }
  return text.size();
}

}  // namespace

int line_of_endless_key(std::string_view text) {
  int parts = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    switch (text[i]) {
      case '#':
        i = std::min(text.find('\n', i), text.size());
        parts = 1;
        break;
      case '"':
      case '\'': i = end_of_string(text, i); break;
      case '.':
        if (++parts > max_key_parts) {
          return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i), '\n'));
        }
        break;
      case '\n':
      case '=':
      case ',':
      case '[':
      case ']':
      case '{':
      case '}': parts = 1; break;
      default: break;
    }
  }
  return 0;
}

}  // namespace artcal
