#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace artcal {

/// What to ask where a text is refused as a number because it has a comma for a point: "; is the comma a decimal comma?
/// Write "3,5 um" with a point: 3.5 um" of "3,5 um". Empty of every other text. To be put behind a message.
std::string decimal_comma_question(std::string_view text);

/// The same of a line of TOML such as "d = 3,5".
std::string decimal_comma_question_of_line(std::string_view line);

}  // namespace artcal
