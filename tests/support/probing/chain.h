#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace artcal::probing {

/// A standard Denavit–Hartenberg arm by products of 4 x 4 matrices, written for the studies alone: it shares nothing
/// with the arm under test. Lengths in mm, angles in rad.
struct Chain {
  Eigen::VectorXd a, d, theta, alpha;
  double l = 0.0;  ///< of the stylus along the last frame's z axis

  [[nodiscard]] int joints() const { return static_cast<int>(a.size()); }
};

/// Number of parameters: a, d, theta, alpha of each joint, then l. `parameters` and `with_parameters` use that order.
Eigen::VectorXd parameters(const Chain& chain);
Chain with_parameters(const Chain& chain, const Eigen::VectorXd& values);

/// Gao, Lu, Yang 2013, Table 1.
Chain gao_chain();

/// Where the tip is, and the axes of all frames along the way: frames[i] before joint i, the last after all.
struct Posture {
  std::vector<Eigen::Matrix4d> frames;
  Eigen::Vector3d tip;
  [[nodiscard]] Eigen::Vector3d stylus() const { return frames.back().block<3, 1>(0, 2); }
};
Posture posture(const Chain& chain, const Eigen::VectorXd& q);

/// Derivative of the tip by parameters(chain), 3 x (4 n + 1).
Eigen::Matrix3Xd tip_by_parameters(const Chain& chain, const Posture& posture);

/// Joint angles that put the tip to `tip` with the stylus along `stylus` (unit), from the start `q` by damped least
/// squares; nothing where that does not converge.
std::optional<Eigen::VectorXd> reach(const Chain& chain, const Eigen::Vector3d& tip, const Eigen::Vector3d& stylus,
                                     Eigen::VectorXd q);

}  // namespace artcal::probing
