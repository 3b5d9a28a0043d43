#pragma once

#include <string>

namespace artcal {

/// Writes all of a text to an open file, past interruptions and partial writes. False where it cannot; errno says why.
bool write_all(int file, const std::string& text);

}  // namespace artcal
