#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "core/files/input_file.h"

namespace artcal {

/// What every result begins with: schema_version, kind and the program that made it.
nlohmann::ordered_json result_head(const char* kind);

/// The files that a result rests on.
nlohmann::ordered_json inputs_json(const std::vector<InputFile>& inputs);

}  // namespace artcal
