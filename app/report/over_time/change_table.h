#pragma once

#include <string>

#include "app/report/html.h"

namespace artcal {

/// A parameter before and after, in mm, rad or what multiplies one, and the standard uncertainty of the change.
struct ChangeRow {
  std::string name;
  std::string unit;  ///< of the numbers, as a result says it
  double then = 0.0;
  double now = 0.0;
  double u = 0.0;
  std::string remark;  ///< what is notable of it; or empty
};

/// A table of changes without rows yet.
html::Table change_table(const std::string& caption);

/// In the unit that a person reads the parameter in.
void add(html::Table& table, const ChangeRow& change);

}  // namespace artcal
