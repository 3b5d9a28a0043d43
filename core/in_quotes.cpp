#include "core/in_quotes.h"

#include <algorithm>

namespace artcal {
namespace {

bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }
bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

}  // namespace

std::string at_most(std::size_t characters, std::string_view text) {
  std::string shown;
  std::size_t count = 0;
  for (const char c : text) {
    if (starts_character(c) && ++count > characters) {
      return shown + "…";
    }
    shown += is_control(c) ? '?' : c;
  }
  return shown;
}

std::string in_quotes(std::string_view found) { return '"' + at_most(40, found) + '"'; }

std::size_t character_count(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), starts_character));
}

}  // namespace artcal
