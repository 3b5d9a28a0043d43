#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace artcal {

/// A character that is obeyed rather than shown.
struct ControlCharacter {
  std::size_t offset = 0;  ///< of its first byte
  std::size_t length = 0;  ///< in bytes
  int code = 0;            ///< code point
};

/// The first character of UTF-8 text that a terminal obeys or that turns the direction of reading: control
/// characters (C0 but the tab, DEL, C1), line and paragraph separators, marks of direction. No label and no
/// name has a use for one.
std::optional<ControlCharacter> find_control(std::string_view utf8);

/// The first `characters` of UTF-8 text, and "…" where there is more; control characters as '?'. What
/// stands in a file may be long, or hostile to a terminal.
std::string truncated(std::size_t characters, std::string_view text);

/// What a message shows of something found in a file: in quotes, at most 40 characters of it.
std::string in_quotes(std::string_view found);

/// Number of characters (code points) in UTF-8 text.
std::size_t character_count(std::string_view utf8);

}  // namespace artcal
