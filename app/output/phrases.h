#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <vector>

namespace artcal {

/// "1 reading", "2 readings".
std::string plural(std::size_t count, const std::string& noun);

/// With a full stop at its end, unless it ends with a question.
std::string as_sentence(const std::string& text);

/// A line "Warning: …." for each; nothing for none.
std::string warning_lines(const std::vector<std::string>& warnings);

/// An exception that nothing below has made an error of: no more threads, which the user can do something about, or a
/// fault of this program.
std::string text_of_exception(const std::exception& error);

}  // namespace artcal
