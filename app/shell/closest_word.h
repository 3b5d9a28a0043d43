#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace artcal {

/// The word that was probably meant: the one with the fewest insertions, deletions, exchanges of a letter and of
/// neighbouring letters (optimal string alignment), at most a third of its length; else one that begins with `typed`,
/// where there is only one. Ties go to the first.
std::optional<std::string> closest_word(std::string_view typed, const std::vector<std::string>& words);

/// "; did you mean X?" or nothing.
std::string did_you_mean(std::string_view typed, const std::vector<std::string>& words);

}  // namespace artcal
