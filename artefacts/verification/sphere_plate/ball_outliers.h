#pragma once

#include <Eigen/Core>

namespace artcal {

/// How far each point is from where the pose of all the others foretells it, in standard deviations of theirs.
struct BallOutlierTest {
  Eigen::VectorXd distances;
  double limit = 0.0;  ///< chance exceeds it in one set of a hundred; 0: too few points to tell
};

/// With nine points or more the scatter of the others may differ by direction (Hotelling's T², with the
/// leverage of the point left out); with fewer it is taken as the same in all directions. One strange point
/// does not hide itself, for it is in no scatter that it is held against.
/// REQUIRES: as many columns in both.
BallOutlierTest studentised_residuals(const Eigen::Matrix3Xd& measured, const Eigen::Matrix3Xd& certified);

}  // namespace artcal
