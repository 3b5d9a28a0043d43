#pragma once

#include <vector>

#include <Eigen/Core>

#include "identification/system.h"

namespace artcal {

/// Where an arm has the tips of one feature's readings.
struct Tips {
  const FeatureConstraint* feature = nullptr;
  Eigen::Matrix3Xd centres;  ///< in the base frame, mm; a column a reading
  Eigen::VectorXd radii;     ///< of the tip of each reading, mm
};

inline Tips tips_of(const System& system, const FeatureConstraint& feature, const std::vector<Sweep>& sweeps) {
  Tips tips{&feature, Eigen::Matrix3Xd(3, feature.size()), Eigen::VectorXd(feature.size())};
  for (int k = 0; k < feature.size(); ++k) {
    const int reading = feature.readings[k];
    const Sweep& sweep = sweeps[system.probes[reading]];
    tips.centres.col(k) = sweep.tip_in_base(system.sines_of(reading));
    tips.radii[k] = sweep.tip_radius();
  }
  return tips;
}

/// Of all features, as Constraints::features.
inline std::vector<Tips> all_tips(const System& system, const Arm& arm) {
  const auto sweeps = sweeps_of(system, arm);
  std::vector<Tips> tips;
  for (const FeatureConstraint& feature : system.constraints->features) {
    tips.push_back(tips_of(system, feature, sweeps));
  }
  return tips;
}

/// How far the tips of a ball or anchor are to be from its centre, mm.
inline Eigen::VectorXd distances_from_centre(const Tips& tips, const Eigen::VectorXd& shared) {
  const FeatureConstraint& feature = *tips.feature;
  if (feature.demand == Demand::AtDistance) {
    return Eigen::VectorXd::Map(feature.distances.data(), feature.size());
  }
  const double radius = feature.shared_radius >= 0 ? feature.expansion * shared[feature.shared_radius] : feature.radius;
  return tips.radii.array() + radius;
}

}  // namespace artcal
