#pragma once

#include <nlohmann/json.hpp>

#include "app/results/drift/parameter_comparison.h"

namespace artcal {

/// The parameters of an identification's result. Throws std::exception where the JSON is not as the schema says.
CalibratedParameters calibrated_parameters(const nlohmann::ordered_json& result);

}  // namespace artcal
