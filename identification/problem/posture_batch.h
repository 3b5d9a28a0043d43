#pragma once

#include <array>

#include "acquisition/arm/kernels/chain.h"
#include "identification/problem/system.h"

namespace artcal {

/// Readings of a feature that ForwardKinematics::tips_in_base() takes at once: one behind the other, by the same probe.
struct PostureBatch {
  std::array<JointReading, postures_at_once> readings;  ///< the first `count` count
  int count = 1;
};

/// From reading `first` on, of those before `end`.
PostureBatch posture_batch(const System& system, const FeatureConstraint& feature, int first, int end);

}  // namespace artcal
