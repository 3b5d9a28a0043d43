#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace artcal {

/// Parts of a result that are tables: parameters, readings and lengths of an identification; verdicts and lengths of a
/// verification; values of a fitted feature. The first is what is meant where none is named.
std::vector<std::string> table_parts(const nlohmann::ordered_json& result);

/// A part as CSV (RFC 4180 with line ends of one character), a header first. Numbers have the digits of the JSON; what
/// is null is empty; units are in the columns' names as they are in the JSON's keys. Every field is a column, also one
/// that this version does not know. Refused: a part that the result does not have, or that is damaged (table_check.h).
Expected<std::string> result_csv(const nlohmann::ordered_json& result, std::string_view part);

/// Rows of flat or nested objects as CSV. Columns are the keys in the order in which they appear first; those of nested
/// objects follow a point (budget.form_mm), elements of lists are numbered from 1 (at_mm.1).
std::string csv_of_rows(const nlohmann::ordered_json& rows);

}  // namespace artcal
