#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace artcal {

/// "1 reading", "2 readings".
std::string plural(std::size_t count, const std::string& noun);

/// A line "Warning: …." for each; nothing for none.
std::string warning_lines(const std::vector<std::string>& warnings);

}  // namespace artcal
