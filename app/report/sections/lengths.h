#pragma once

#include <nlohmann/json.hpp>

#include "app/report/sheet.h"

namespace artcal {

/// The certified lengths of an identification, each measured and not fitted: table and picture.
/// Throws std::exception where the JSON is not as docs/result-schema.md says.
void write_length_errors(const nlohmann::ordered_json& identification, Sheet& sheet);

}  // namespace artcal
