#pragma once

#include <cstdint>
#include <optional>

#include <nlohmann/json.hpp>

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "identification/identify.h"

namespace artcal {

/// Wall-clock seconds; the only part of a result that differs from run to run.
struct Timings {
  double reading = 0.0;
  double identifying = 0.0;
};

/// What every result begins with: what made it, of what, from which files.
nlohmann::ordered_json result_header(const Recording& recording, const char* kind,
                                     const std::optional<std::uint64_t>& seed);

/// Results as JSON. The schema is docs/result-schema.md; `schema_version` changes with it.
nlohmann::ordered_json to_json(const Recording& recording, const Constraints& constraints,
                               const IdentifyOptions& options, const Identification& result, const Timings& timings);

}  // namespace artcal
