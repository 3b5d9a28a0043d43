#pragma once

#include <limits>
#include <optional>

#include <Eigen/Core>

#include "artefacts/simulation/virtual_arm.h"
#include "core/random.h"

namespace artcal {

/// On which side of the plane through the first axis and the tip the elbow is: the joint furthest from that
/// plane, seen along the first axis' sense of up from the base towards the tip.
enum class Elbow { Either, Left, Right };

/// The elbow's side in a posture; Either where the elbow is in the plane to within a thousandth of the reach.
Elbow elbow_side(const Arm& arm, int probe, const Eigen::VectorXd& rigid_readings);

/// What is asked of a posture.
struct PostureRequest {
  int probe = 0;
  Eigen::Vector3d tip_in_base = Eigen::Vector3d::Zero();  ///< mm
  Elbow elbow = Elbow::Either;                            ///< a wish: the other side where this one cannot be had
  Eigen::VectorXd encoder_noise;  ///< rad, what comes on top of the readings; the sum keeps to the stops
  double margin = 0.0;            ///< rad that the readings keep from the stops
  double arm_temperature = std::numeric_limits<double>::quiet_NaN();  ///< °C; NaN: the arm's reference
};

/// Joint readings without noise (rad) that have the tip where it is asked for, from a random start between the
/// end stops: elbow, wrist and all other redundancy fall where the start has them. Nothing if 200 starts
/// lead nowhere.
std::optional<Eigen::VectorXd> find_posture(const VirtualArm& arm, const PostureRequest& request, RandomStream& random);

/// The same from a given start (readings), which the redundancy keeps the posture near.
std::optional<Eigen::VectorXd> find_posture_near(const VirtualArm& arm, const PostureRequest& request,
                                                 const Eigen::VectorXd& start);

/// Readings anywhere between the end stops.
Eigen::VectorXd random_readings(const VirtualArm& arm, RandomStream& random);

}  // namespace artcal
