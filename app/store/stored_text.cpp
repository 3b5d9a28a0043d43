#include "app/store/stored_text.h"

#include <algorithm>

#include <fmt/format.h>

namespace artcal {
namespace {

bool is_in(unsigned char c, unsigned low, unsigned high) { return c >= low && c <= high; }

// Length of the UTF-8 character that begins at `at` (RFC 3629, section 4), or 0.
std::size_t character_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : static_cast<unsigned char>(0);
  };
  const auto tails = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      if (!is_in(byte(i), 0x80, 0xbf)) {
        return false;
      }
    }
    return true;
  };
  const unsigned char lead = byte(0);
  if (lead < 0x80) {
    return 1;
  }
  if (is_in(lead, 0xc2, 0xdf)) {
    return tails(1, 2) ? 2 : 0;
  }
  if (is_in(lead, 0xe0, 0xef)) {
    const bool second = is_in(byte(1), lead == 0xe0 ? 0xa0 : 0x80, lead == 0xed ? 0x9f : 0xbf);
    return second && tails(2, 3) ? 3 : 0;
  }
  const bool second = is_in(byte(1), lead == 0xf0 ? 0x90 : 0x80, lead == 0xf4 ? 0x8f : 0xbf);
  return is_in(lead, 0xf0, 0xf4) && second && tails(2, 4) ? 4 : 0;
}

}  // namespace

std::string valid_utf8(const std::string& text) {
  std::string valid;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_at(text, i);
    valid += length > 0 ? text.substr(i, length) : fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i]));
    i += std::max<std::size_t>(length, 1);
  }
  return valid;
}

std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

}  // namespace artcal
