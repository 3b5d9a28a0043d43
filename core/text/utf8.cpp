#include "core/text/utf8.h"

#include <cstdint>
#include <cstring>

namespace artcal {
namespace {

// Length of the UTF-8 character that `text` begins with, or 0 if it begins with none (RFC 3629).
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const unsigned first = byte(0);
  if (first < 0x80) {
    return 1;
  }
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) {
      return 0;
    }
  }
  // Overlong forms, surrogates and what lies beyond the last code point.
  const unsigned second = byte(1);
  const bool beyond = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                      (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return beyond ? 0 : length;
}

constexpr std::size_t ascii_step = sizeof(std::uint64_t);

// Whether the next eight bytes are there and ASCII: nearly all of nearly every file.
bool is_ascii(std::string_view text, std::size_t at) {
  std::uint64_t bytes = ~std::uint64_t{0};
  if (text.size() - at >= ascii_step) {
    std::memcpy(&bytes, text.data() + at, ascii_step);
  }
  return (bytes & 0x8080808080808080u) == 0;
}

}  // namespace

std::size_t find_not_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    if (is_ascii(text, i)) {
      i += ascii_step;
      continue;
    }
    const std::size_t length = character_length(text.substr(i));
    if (length == 0) {
      return i;
    }
    i += length;
  }
  return std::string_view::npos;
}

}  // namespace artcal
