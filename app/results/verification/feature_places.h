#pragma once

#include <nlohmann/json.hpp>

#include "artefacts/verification/session.h"

namespace artcal {

/// Where each feature of each placement is, in the base frame and once whatever its repeats: centre of a ball, mean of
/// the readings of a seat or a face. For pictures. Schema: docs/result-schema.md, "feature_place".
nlohmann::ordered_json feature_places_json(const Session& session);

}  // namespace artcal
