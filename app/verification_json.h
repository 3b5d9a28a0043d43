#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "artefacts/verification/session.h"
#include "artefacts/verification/verify.h"

namespace artcal {

/// A verification as JSON. The schema is docs/result-schema.md.
nlohmann::ordered_json to_json(const Session& session, const VerificationResult& result);

/// The values of an earlier verification, read from such a result. Refused: what is no such result, or one of
/// another standard.
Expected<std::vector<TestValue>> read_earlier_values(const std::string& path, const std::string& standard,
                                                     std::vector<InputFile>& inputs);

}  // namespace artcal
