#pragma once

#include <string>

#include "core/error.h"

namespace artcal {

/// Writes the text of an arm to `output` and says `said` and where it is; without an output, or with "-", prints the
/// text alone, and `said` on standard error.
Expected<int> give_arm(const std::string& output, bool quiet, const std::string& text, const std::string& said);

}  // namespace artcal
