#pragma once

#include <string>
#include <vector>

#include "artefacts/verification/verification.h"
#include "core/error.h"
#include "core/files/input_file.h"

namespace artcal {

/// The values of an earlier verification, read from its result as JSON, for an interim check. Refused: what is no such
/// result, one of another standard, a quantity that no verification has.
Expected<std::vector<TestValue>> read_earlier_values(const std::string& path, const std::string& standard,
                                                     std::vector<InputFile>& inputs);

}  // namespace artcal
