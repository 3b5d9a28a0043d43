#include "acquisition/arm/stretched_length.h"

#include <algorithm>
#include <vector>

#include <Eigen/Cholesky>

#include "acquisition/arm/forward_kinematics.h"

namespace artcal {
namespace {

constexpr int iterations = 40;
constexpr double far_foot = 10.0;       // times the length of the arm
constexpr double shortest_link = 1e-3;  // mm; what is shorter counts by this in the weights

/// The axes in one posture, and a tip.
struct Axes {
  Eigen::Matrix3Xd directions, points;
  Eigen::Vector3d tip;
};

Axes axes_of(Arm arm, int probe) {
  for (Joint& joint : arm.joints) {
    joint.errors = {};
    joint.mechanical_coupling = 0.0;
  }
  const auto count = static_cast<Eigen::Index>(arm.joints.size());
  const std::vector<double> q(arm.joints.size(), 0.0);
  std::vector<double> sines(2 * arm.joints.size());
  joint_sines(q, sines);
  Axes axes{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count), {}};
  axes.tip = ForwardKinematics(arm, {}, probe).axes_in_base({sines, q}, axes.directions.data(), axes.points.data());
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

// From where the swinging part begins, the first joint's far end along its axis. Where that is far from the arm,
// because d of the first joint cancels with others, from the base's origin.
double shortest_chain(const Arm& arm, const Axes& axes) {
  const Eigen::Vector3d foot = axes.points.col(0) + arm.joints.front().d * axes.directions.col(0);
  const double from_foot = shortest_chain(axes, foot);
  const double from_base = shortest_chain(axes, Eigen::Vector3d::Zero());
  return from_foot > far_foot * from_base ? from_base : from_foot;
}

}  // namespace

double stretched_length(const Arm& arm) {
  double longest = 0.0;
  for (int probe = 0; probe < static_cast<int>(arm.probes.size()); ++probe) {
    longest = std::max(longest, shortest_chain(arm, axes_of(arm, probe)));
  }
  return longest;
}

}  // namespace artcal
