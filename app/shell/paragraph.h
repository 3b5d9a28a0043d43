#pragma once

#include <string>
#include <string_view>

namespace artcal {

/// Text filled to lines of at most `width` characters (UTF-8 code points). The first line goes on where `column`
/// characters stand already; the others begin with `indent` spaces. A word longer than a line has one of its own.
std::string filled(std::string_view text, std::size_t width, std::size_t indent, std::size_t column);

}  // namespace artcal
