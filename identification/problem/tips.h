#pragma once

#include <vector>

#include <Eigen/Core>

#include "identification/problem/system.h"

namespace artcal {

/// Where an arm has the tips of one feature's readings.
struct Tips {
  const FeatureConstraint* feature = nullptr;
  Eigen::Matrix3Xd centres;   ///< in the base frame, mm; a column a reading
  Eigen::VectorXd radii;      ///< of the tip of each reading, mm
  Eigen::Matrix3Xd styluses;  ///< of unknown planes only: unit vectors from the last joint's axis to the tip
};

/// The radius of a ball in its placement, mm, at these values of Constraints::shared; 0 where nobody knows it.
double radius_of(const OnBall& ball, double expansion, const double* shared);

Tips tips_of(const System& system, const FeatureConstraint& feature,
             const std::vector<ForwardKinematics>& kinematics_by_probe);

/// Of all features, as Constraints::features.
std::vector<Tips> all_tips(const System& system, const Arm& arm);

/// How far the tips of a ball or anchor are to be from its centre, mm.
Eigen::VectorXd distances_from_centre(const Tips& tips, const Eigen::VectorXd& shared);

}  // namespace artcal
