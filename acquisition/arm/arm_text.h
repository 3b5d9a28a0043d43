#pragma once

#include <string>

#include "acquisition/arm/arm.h"
#include "core/error.h"

namespace artcal {

/// The arm that a text in the format of docs/files.md, "arm.toml", states, as arm_file_text() writes it; refused like a
/// file of that content, under `name`.
Expected<Arm> arm_of_text(const std::string& text, const std::string& name);

}  // namespace artcal
