#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "identification/monte_carlo/monte_carlo.h"

namespace artcal {

/// A Monte Carlo's counts as a file, so that another run can go on from them (docs/files.md). `made_from` says of what
/// they are: a count goes on only from the same.
std::string state_text(const MonteCarloCount& count, const nlohmann::ordered_json& made_from);

/// Bad input: no such file, damaged, of another program, recording or request, numbers that contradict each other.
Expected<MonteCarloCount> read_state(const std::string& path, const nlohmann::ordered_json& made_from);

}  // namespace artcal
