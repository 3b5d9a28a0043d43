#pragma once

#include <nlohmann/json.hpp>

#include "app/report/sheet.h"

namespace artcal {

/// Whether there were trials enough, and whether first-order uncertainties agree with them.
void write_monte_carlo_verdict(const nlohmann::ordered_json& result, Sheet& sheet);

/// Uncertainties of parameters and of what the arm measures, by Monte Carlo and to first order. Both throw
/// std::exception where the JSON is not as docs/result-schema.md says.
void write_monte_carlo(const nlohmann::ordered_json& result, Sheet& sheet);

}  // namespace artcal
