#pragma once

#include <nlohmann/json.hpp>

#include "identification/identify.h"

namespace artcal {

/// The model that was identified and what `--model auto` tried. Schema: docs/result-schema.md, "model".
nlohmann::ordered_json model_json(const Identification& result);

/// What the residuals hold that the model lacks. Schema: "model_study".
nlohmann::ordered_json model_study_json(const ModelStudy& study);

}  // namespace artcal
