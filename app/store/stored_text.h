#pragma once

#include <string>

namespace artcal {

/// The text with every byte that is no part of UTF-8 as "\xNN": file names may hold any bytes, databases do not.
std::string valid_utf8(const std::string& text);

/// The text in one line, without control characters.
std::string in_one_line(std::string text);

}  // namespace artcal
