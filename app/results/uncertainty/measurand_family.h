#pragma once

#include <string>

namespace artcal {

/// What a Monte Carlo result's quantities of one kind share in a table, by the kind and the name that the result has
/// for them: "E_Uni, 500 mm" for each of many lengths of 500 mm. Empty for a parameter, which has a row of its own.
std::string measurand_family(const std::string& kind, const std::string& name);

}  // namespace artcal
