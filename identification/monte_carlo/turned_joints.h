#pragma once

#include <cmath>
#include <vector>

#include "core/random.h"

namespace artcal {

/// Joints that each read something else by a normal draw of `deviation`, rad: their angles, and by the same draws sines
/// and cosines (JointReading). `sines` holds two numbers for each of `angles`.
inline void turn_joints(std::vector<double>& angles, std::vector<double>& sines, double deviation,
                        RandomStream& random) {
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double by = deviation * random.normal();
    const double s = std::sin(by);
    const double c = std::cos(by);
    const double turned = sines[2 * i] * c + sines[2 * i + 1] * s;
    sines[2 * i + 1] = sines[2 * i + 1] * c - sines[2 * i] * s;
    sines[2 * i] = turned;
    angles[i] += by;
  }
}

}  // namespace artcal
