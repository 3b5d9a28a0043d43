#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "acquisition/recording/recording.h"
#include "artefacts/virtual_probing/virtual_probing.h"
#include "identification/identifiability/coupling.h"

namespace artcal {

/// Schema: docs/result-schema.md, "coupling".
nlohmann::ordered_json coupling_json(const Coupling& coupling);

/// {"a6": 1.0, "theta6": -0.00545}: a motion's parameters, in mm and rad.
nlohmann::ordered_json motion_json(const Coupling& coupling, const ParameterMotion& motion);

/// What a coupling analysis was asked.
struct CouplingRequest {
  std::vector<std::string> hold, free;
  std::string model;
  std::optional<VirtualProbing> made_up;  ///< how the readings were made, if they were
};
nlohmann::ordered_json to_json(const Recording& recording, const Coupling& coupling, const CouplingRequest& request);

}  // namespace artcal
