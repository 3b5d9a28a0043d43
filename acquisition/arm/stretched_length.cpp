#include "acquisition/arm/stretched_length.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include <Eigen/Cholesky>

#include "acquisition/arm/forward_kinematics.h"

namespace artcal {
namespace {

constexpr int iterations = 40;
constexpr int postures = 8;             // of the lower bound
constexpr double far_foot = 10.0;       // times the length of the arm
constexpr double shortest_link = 1e-3;  // mm; what is shorter counts by this in the weights

/// The axes in one posture, and a tip.
struct Axes {
  Eigen::Matrix3Xd directions, points;
  Eigen::Vector3d tip;
};

Arm without_errors(Arm arm) {
  for (Joint& joint : arm.joints) {
    joint.errors = {};
    joint.mechanical_coupling = 0.0;
  }
  return arm;
}

// Joints that turn spread over the circle, others at zero; all at zero for number 0.
std::vector<double> posture(const Arm& arm, int number) {
  std::vector<double> q(arm.joints.size(), 0.0);
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] = arm.joints[i].is_prismatic()
               ? 0.0
               : 2.0 * std::numbers::pi / std::numbers::phi * number * static_cast<double>(i + 1);
  }
  return q;
}

Axes axes_of(const ForwardKinematics& kinematics, const std::vector<double>& q) {
  const int count = kinematics.joint_count();
  std::vector<double> sines(2 * q.size());
  joint_sines(q, sines);
  Axes axes{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count), {}};
  axes.tip = kinematics.axes_in_base({sines, q}, axes.directions.data(), axes.points.data());
  return axes;
}

// The chain from the foot to a point on each axis and to the tip; `places` are the points' places along the axes.
Eigen::Matrix3Xd chain_of(const Axes& axes, const Eigen::Vector3d& foot, const Eigen::VectorXd& places) {
  const Eigen::Index count = places.size();
  Eigen::Matrix3Xd points(3, count + 2);
  points << foot, axes.points + axes.directions * places.asDiagonal(), axes.tip;
  return points.rightCols(count + 1) - points.leftCols(count + 1);
}

double shortest_chain(const Axes& axes, const Eigen::Vector3d& foot) {
  const Eigen::Index count = axes.points.cols();
  // The points nearest the tip: with a large d that cancels the frames' origins are far from the arm.
  Eigen::VectorXd places =
      axes.directions.transpose() * axes.tip - axes.directions.cwiseProduct(axes.points).colwise().sum().transpose();
  double shortest = chain_of(axes, foot, places).colwise().norm().sum();
  for (int i = 0; i < iterations; ++i) {
    const Eigen::Matrix3Xd links = chain_of(axes, foot, places);
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count);
    for (Eigen::Index link = 0; link <= count; ++link) {  // from point link - 1 to point link
      const double weight = 1.0 / std::max(links.col(link).norm(), shortest_link);
      if (link < count) {
        normal(link, link) += weight;
        gradient[link] += weight * axes.directions.col(link).dot(links.col(link));
      }
      if (link > 0) {
        normal(link - 1, link - 1) += weight;
        gradient[link - 1] -= weight * axes.directions.col(link - 1).dot(links.col(link));
      }
      if (link > 0 && link < count) {
        normal(link, link - 1) -= weight * axes.directions.col(link).dot(axes.directions.col(link - 1));
        normal(link - 1, link) = normal(link, link - 1);
      }
    }
    normal.diagonal() *= 1.0 + 1e-9;  // points on parallel axes may slide together
    places -= normal.ldlt().solve(gradient);
    shortest = std::min(shortest, chain_of(axes, foot, places).colwise().norm().sum());
  }
  return shortest;
}

// Where the swinging part begins: the first joint's far end along its axis.
Eigen::Vector3d foot_of(const Arm& arm, const Axes& axes) {
  return axes.points.col(0) + arm.joints.front().d * axes.directions.col(0);
}

// From the foot. Where that is far from the arm, because d of the first joint cancels with others, from the base's
// origin.
double shortest_chain(const Arm& arm, const Axes& axes) {
  const double from_foot = shortest_chain(axes, foot_of(arm, axes));
  const double from_base = shortest_chain(axes, Eigen::Vector3d::Zero());
  return from_foot > far_foot * from_base ? from_base : from_foot;
}

}  // namespace

double least_stretched_length(const Arm& arm) {
  double longest = 0.0;
  for (int probe = 0; probe < static_cast<int>(arm.probes.size()); ++probe) {
    const ForwardKinematics kinematics(without_errors(arm), {}, probe);
    for (int number = 0; number < postures; ++number) {
      const Axes axes = axes_of(kinematics, posture(arm, number));
      longest = std::max(longest, std::min((axes.tip - foot_of(arm, axes)).norm(), axes.tip.norm()));
    }
  }
  return longest;
}

double stretched_length(const Arm& arm) {
  double longest = 0.0;
  for (int probe = 0; probe < static_cast<int>(arm.probes.size()); ++probe) {
    const ForwardKinematics kinematics(without_errors(arm), {}, probe);
    longest = std::max(longest, shortest_chain(arm, axes_of(kinematics, posture(arm, 0))));
  }
  return longest;
}

}  // namespace artcal
