#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace artcal {

/// What a message lists of names that could have been meant: the first twelve in quotes, and how many more there are;
/// "none" of none.
std::string listed_names(const std::vector<std::string>& names);

/// The name that `misspelt` is nearest to, by at most two characters put in, left out or exchanged, and by less than
/// half of them; empty where there is none.
std::string nearest_name(std::string_view misspelt, const std::vector<std::string>& names);

}  // namespace artcal
