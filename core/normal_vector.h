#pragma once

#include <Eigen/Core>

#include "core/random.h"

namespace artcal {

/// Three independent standard normal numbers, drawn z first. As arguments of one call they would be drawn in an order
/// that each compiler chooses, and a trial would be another one with another compiler.
inline Eigen::Vector3d normal_vector(RandomStream& random) {
  const double z = random.normal();
  const double y = random.normal();
  const double x = random.normal();
  return {x, y, z};
}

}  // namespace artcal
