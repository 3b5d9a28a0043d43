#pragma once

#include <nlohmann/json.hpp>

#include "identification/identify.h"

namespace artcal {

/// What readings deviate by with an arm. Schema: docs/result-schema.md, "evaluation".
nlohmann::ordered_json evaluation_json(const Evaluation& evaluation);

/// An arm evaluated on readings. Schema: "evaluation_result". REQUIRES: `recording.arm` is the arm evaluated.
nlohmann::ordered_json to_json(const Recording& recording, const Constraints& constraints,
                               const Evaluation& evaluation);

/// One placement judged by an arm that was identified without it. Schema: "left_out".
nlohmann::ordered_json left_out_json(const LeftOut& left);

}  // namespace artcal
