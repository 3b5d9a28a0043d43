#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/history/arm_history.h"

namespace artcal {

/// What a technician reads: what was done when with which certificate, then what changed and whether it is
/// significant. `all` lists every change, not only the significant ones.
std::string to_text(const ArmHistory& history, bool all);

/// The table `history` of docs/result-schema.md.
nlohmann::ordered_json to_json(const ArmHistory& history);

}  // namespace artcal
