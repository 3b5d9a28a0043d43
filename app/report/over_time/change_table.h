#pragma once

#include <string>
#include <vector>

#include "app/report/html.h"
#include "app/results/drift/parameter_comparison.h"

namespace artcal {

/// A change from a first to a last result, in the unit in which a person reads it.
struct ShownChange {
  std::string what, beside;       ///< cells of the first two columns
  std::string then, now, change;  ///< numbers as they are written
  double u = 0.0;                 ///< standard uncertainty of the change
  double times_u = 0.0;           ///< |change| / u
  bool significant = false;
  std::string remark = {};  ///< where it is not significant
};

/// A table of changes; those that are significant are marked. `what` and `beside` head the first two columns.
html::Table change_table(const std::string& caption, const std::string& what, const std::string& beside,
                         const std::vector<ShownChange>& changes);

/// The same of parameters.
html::Table change_table(const std::string& caption, const std::vector<ParameterChange>& changes);

}  // namespace artcal
