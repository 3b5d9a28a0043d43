#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "artefacts/verification/session.h"
#include "artefacts/verification/verify.h"

namespace artcal {

/// A verification as JSON. The schema is docs/result-schema.md.
nlohmann::ordered_json to_json(const Session& session, const VerificationResult& result);

}  // namespace artcal
