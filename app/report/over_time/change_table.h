#pragma once

#include <string>
#include <vector>

#include "app/report/html.h"
#include "app/results/drift/parameter_comparison.h"

namespace artcal {

/// A table of changes, each in the unit that a person reads the parameter in; those that are significant are marked.
html::Table change_table(const std::string& caption, const std::vector<ParameterChange>& changes);

}  // namespace artcal
