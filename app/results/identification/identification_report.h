#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "acquisition/recording/recording.h"
#include "core/error.h"
#include "identification/identify.h"

namespace artcal {

/// The page of an identification (`json`, as to_json makes it, with its residuals), and of what the identified arm
/// may be expected to measure like with its first probe and the noise of its readings. Nothing for an empty path.
Expected<void> write_identification_report(const std::string& path, const nlohmann::ordered_json& json,
                                           const Recording& recording, const IdentifyOptions& options,
                                           const Identification& result);

}  // namespace artcal
