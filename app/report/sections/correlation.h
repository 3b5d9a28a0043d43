#pragma once

#include <nlohmann/json.hpp>

#include "app/report/sheet.h"

namespace artcal {

/// The correlation matrix of the identified parameters (table "covariance" of docs/result-schema.md), with the closest
/// pairs in words. Throws std::exception where the matrix is not as large as its names are many.
Figure correlation_of(const nlohmann::ordered_json& covariance);

}  // namespace artcal
