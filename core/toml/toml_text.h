#pragma once

#include <string>
#include <string_view>

namespace artcal {

/// Text as a TOML basic string, quotes included.
std::string toml_text(std::string_view text);

/// A number as a TOML float: the shortest digits that read back to the same double.
std::string toml_number(double value);

}  // namespace artcal
