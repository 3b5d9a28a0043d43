#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "identification/reported_coordinates/reported_model.h"

namespace artcal {

/// What `artcal arm from-coordinates` says: how columns go to joints, the residuals, the rank, the parameters. `output`
/// is the arm file written, or empty.
std::string reported_text(const ReportedModel& model, const std::string& output);

/// The same as JSON; the schema is docs/result-schema.md, "reported_model".
nlohmann::ordered_json reported_json(const ReportedModel& model);

}  // namespace artcal
