#include "core/text/in_quotes.h"

#include <algorithm>

#include "core/text/utf8.h"

namespace artcal {
namespace {

bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

// The control character that `text` begins with; length 0 if it begins with none.
ControlCharacter control_at(std::string_view text, std::size_t offset) {
  const auto byte = [&](std::size_t i) {
    return offset + i < text.size() ? static_cast<int>(static_cast<unsigned char>(text[offset + i])) : 0;
  };
  if ((byte(0) < 0x20 && byte(0) != '\t') || byte(0) == 0x7f) {
    return {offset, 1, byte(0)};
  }
  if (byte(0) == 0xC2 && byte(1) >= 0x80 && byte(1) < 0xA0) {
    return {offset, 2, byte(1)};
  }
  if (byte(0) == 0xE2) {
    const int code = 0x2000 + (byte(1) - 0x80) * 0x40 + byte(2) - 0x80;
    if ((code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069)) {
      return {offset, 3, code};
    }
  }
  return {};
}

}  // namespace

std::string truncated(std::size_t characters, std::string_view text) {
  constexpr std::size_t longest_character = 4;
  text = text.substr(0, longest_character * (characters + 1));  // where characters end, it is known that there is more
  const auto stray_from = [&](std::size_t begin) {
    const std::size_t stray = find_not_utf8(text.substr(begin));
    return stray == std::string_view::npos ? stray : begin + stray;
  };
  std::string shown;
  std::size_t count = 0;
  std::size_t stray = stray_from(0);
  for (std::size_t i = 0; i < text.size(); ++i) {
    // A byte that is no part of UTF-8 is a character by itself: a field of nothing else has an end too.
    if ((i == stray || starts_character(text[i])) && ++count > characters) {
      return shown + "…";
    }
    if (i == stray) {
      shown += '?';
      stray = stray_from(i + 1);
      continue;
    }
    const std::size_t control = control_at(text, i).length;
    shown += control > 0 || text[i] == '\t' ? '?' : text[i];
    i += control > 1 ? control - 1 : 0;
  }
  return shown;
}

std::optional<ControlCharacter> find_control(std::string_view utf8) {
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    if (utf8[i] >= 0x20 && utf8[i] < 0x7f) {
      continue;  // nearly every character of nearly every file
    }
    if (const ControlCharacter found = control_at(utf8, i); found.length > 0) {
      return found;
    }
  }
  return std::nullopt;
}

std::string in_quotes(std::string_view found) { return '"' + truncated(40, found) + '"'; }

std::size_t character_count(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), starts_character));
}

}  // namespace artcal
