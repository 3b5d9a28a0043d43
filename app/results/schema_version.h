#pragma once

#include <nlohmann/json.hpp>

namespace artcal {

/// Of the results that this program writes (docs/result-schema.md).
inline constexpr int schema_version = 2;

/// Renames what a result of an older schema names differently, so that what reads results knows one schema only. False:
/// no schema_version that this program knows. Fields that are missing or of another type stay as they are.
bool bring_up_to_date(nlohmann::ordered_json& result);

}  // namespace artcal
