#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/arm.h"
#include "acquisition/arm/forward_kinematics.h"
#include "acquisition/arm/parameters.h"

namespace artcal {

/// What makes the points of an identified arm uncertain.
struct UncertaintySources {
  std::vector<Parameter> parameters;  ///< the identified ones
  Eigen::MatrixXd covariance;         ///< of these, mm and rad
  double encoder = 0.0;               ///< standard deviation of each joint's reading, rad
  double probing = 0.0;               ///< of each coordinate of the tip beside that, mm
};

/// The tip at one posture, and how it moves with what is uncertain.
struct UncertainTip {
  Eigen::Vector3d in_base;        ///< mm
  Eigen::Matrix3Xd by_parameter;  ///< columns as UncertaintySources::parameters, mm per mm or rad
  Eigen::Matrix3Xd by_joint;      ///< mm per rad
};

/// First-order uncertainty (GUM, JCGM 100 §5.2) of whatever is linear in tips. The parameters are the same at every
/// posture, so their share is common to all tips and cancels in part; encoder and probing noise are new in
/// every reading. Held parameters carry no uncertainty: a coordinate is uncertain within the base frame that
/// they define, a length does not know of frames.
class UncertainArm {
 public:
  UncertainArm(Arm arm, UncertaintySources sources, int probe = 0);

  [[nodiscard]] UncertainTip tip(const Eigen::VectorXd& q) const;

  /// Standard uncertainty of Σ gradient[k] · tip[k], in the unit that makes, such as mm.
  [[nodiscard]] double of_combination(std::span<const UncertainTip> tips,
                                      std::span<const Eigen::Vector3d> gradients) const;

  /// Covariance of one tip, mm².
  [[nodiscard]] Eigen::Matrix3d of_point(const UncertainTip& tip) const;
  /// Standard uncertainty of the distance between two tips, mm. REQUIRES: they are apart.
  [[nodiscard]] double of_length(const UncertainTip& first, const UncertainTip& second) const;
  /// Standard uncertainty of the diameter of a ball with this centre that the tips touch from outside: of their
  /// least-squares sphere's, less the tip's own, mm. REQUIRES: four tips or more, not all in one plane.
  [[nodiscard]] double of_diameter(std::span<const UncertainTip> tips, const Eigen::Vector3d& centre_in_base) const;

  /// The same arm with readings that have no noise: what is left is the identification's.
  [[nodiscard]] UncertainArm without_noise() const;

  [[nodiscard]] const Arm& arm() const { return arm_; }
  [[nodiscard]] int probe() const { return probe_; }

 private:
  // The same beside a change of the result by the parameters themselves.
  [[nodiscard]] double of_combination(std::span<const UncertainTip> tips, std::span<const Eigen::Vector3d> gradients,
                                      Eigen::VectorXd by_parameter) const;

  Arm arm_;
  UncertaintySources sources_;
  int probe_;
  ForwardKinematics kinematics_;
};

}  // namespace artcal
