#pragma once

#include <string>
#include <string_view>

namespace artcal {

/// The first `characters` of UTF-8 text, and "…" where there is more; control characters as '?'. What
/// stands in a file may be long, or hostile to a terminal.
std::string at_most(std::size_t characters, std::string_view text);

/// What a message shows of something found in a file: in quotes, at most 40 characters of it.
std::string in_quotes(std::string_view found);

/// Number of characters (code points) in UTF-8 text.
std::size_t character_count(std::string_view utf8);

}  // namespace artcal
