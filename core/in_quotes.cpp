#include "core/in_quotes.h"

#include <algorithm>

namespace artcal {
namespace {

constexpr std::size_t shown_characters = 40;

bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }
bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

}  // namespace

std::string in_quotes(std::string_view found) {
  std::string shown = "\"";
  std::size_t characters = 0;
  for (const char c : found) {
    if (starts_character(c) && ++characters > shown_characters) {
      return shown + "…\"";
    }
    shown += is_control(c) ? '?' : c;
  }
  return shown + "\"";
}

std::size_t character_count(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), starts_character));
}

}  // namespace artcal
