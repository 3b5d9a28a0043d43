#pragma once

#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/arm.h"

namespace artcal {

/// How columns of joint readings go to the joints of an arm: joint i reads sign[i]·factor·(column[i]).
struct JointAssignment {
  std::vector<int> column;
  std::vector<double> sign;
  double factor = 1.0;  ///< of angles; 180/π where what was read as degrees is radians

  [[nodiscard]] bool keeps_order() const;
  [[nodiscard]] bool changes_nothing() const;
};

/// The readings as the arm's joints have them: joint × reading.
Eigen::MatrixXd assigned(const JointAssignment& assignment, const Arm& arm, const Eigen::MatrixXd& columns);

/// What the nominal arm makes of the readings under each assignment, against the coordinates reported for them (3 ×
/// readings, in the base frame, or up to a rigid motion where the frame is unknown): the `count` assignments with the
/// smallest rms, best first. Signs and units are tried in the order of the columns, and with `permuted`, for up to 7
/// joints, in every other order too; columns of revolute and of prismatic joints are not exchanged. Of more than 10
/// joints at most one counts the other way.
std::vector<JointAssignment> likely_assignments(const Arm& nominal, const Eigen::MatrixXd& columns,
                                                const Eigen::Matrix3Xd& coordinates, const std::vector<int>& probes,
                                                bool base_frame_is_known, bool permuted, std::size_t count);

}  // namespace artcal
