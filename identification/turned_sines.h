#pragma once

#include <cmath>
#include <vector>

#include "core/random.h"

namespace artcal {

/// Sines and cosines (JointSines) of joints that each read something else by a normal draw of `deviation`, rad.
inline void turn_sines(std::vector<double>& sines, double deviation, RandomStream& random) {
  for (std::size_t i = 0; i + 1 < sines.size(); i += 2) {
    const double by = deviation * random.normal();
    const double s = std::sin(by);
    const double c = std::cos(by);
    const double turned = sines[i] * c + sines[i + 1] * s;
    sines[i + 1] = sines[i + 1] * c - sines[i] * s;
    sines[i] = turned;
  }
}

}  // namespace artcal
