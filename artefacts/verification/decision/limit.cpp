#include "artefacts/verification/decision/limit.h"

#include <algorithm>

namespace artcal {

double Limit::at(double length) const {
  const double limit = base + slope * length;
  return most ? std::min(limit, *most) : limit;
}

}  // namespace artcal
