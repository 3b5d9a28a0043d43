#include "identification/problem/posture_batch.h"

namespace artcal {

PostureBatch posture_batch(const System& system, const FeatureConstraint& feature, int first, int end) {
  const auto reading = [&](int k) { return system.sines_of(feature.readings[k]); };
  const JointReading one = reading(first);
  PostureBatch found{{one, one, one, one, one, one, one, one}, 1};
  const int probe = system.probes[feature.readings[first]];
  for (int k = first + 1; found.count < postures_at_once && k < end; ++k) {
    if (system.probes[feature.readings[k]] != probe) {
      break;
    }
    found.readings[static_cast<std::size_t>(found.count++)] = reading(k);
  }
  return found;
}

}  // namespace artcal
