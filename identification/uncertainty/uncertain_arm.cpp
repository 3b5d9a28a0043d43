#include "identification/uncertainty/uncertain_arm.h"

#include <array>
#include <cmath>
#include <utility>

#include <Eigen/QR>

namespace artcal {

UncertainArm::UncertainArm(Arm arm, UncertaintySources sources, int probe)
    : arm_(std::move(arm)),
      sources_(std::move(sources)),
      probe_(probe),
      kinematics_(arm_, sources_.parameters, probe) {}

UncertainArm UncertainArm::without_noise() const {
  return {arm_, {sources_.parameters, sources_.covariance, 0.0, 0.0}, probe_};
}

UncertainTip UncertainArm::tip(const Eigen::VectorXd& q) const {
  std::vector<double> sines(2 * static_cast<std::size_t>(q.size()));
  const std::span<const double> angles(q.data(), static_cast<std::size_t>(q.size()));
  joint_sines(angles, sines);
  UncertainTip tip;
  tip.by_parameter.resize(3, kinematics_.column_count());
  tip.by_joint.resize(3, kinematics_.joint_count());
  kinematics_.tip_by_joints({sines, angles}, tip.by_joint.data());
  for (std::size_t i = 0; i < arm_.joints.size(); ++i) {
    if (arm_.joints[i].is_prismatic()) {
      tip.by_joint.col(static_cast<Eigen::Index>(i)).setZero();  // its noise is a length, part of the probing noise
    }
  }
  tip.in_base = kinematics_.tip_in_base({sines, angles}, tip.by_parameter.data());
  return tip;
}

double UncertainArm::of_combination(std::span<const UncertainTip> tips,
                                    std::span<const Eigen::Vector3d> gradients) const {
  return of_combination(tips, gradients, Eigen::VectorXd::Zero(sources_.covariance.rows()));
}

double UncertainArm::of_combination(std::span<const UncertainTip> tips, std::span<const Eigen::Vector3d> gradients,
                                    Eigen::VectorXd by_parameter) const {
  double of_readings = 0.0;
  for (std::size_t k = 0; k < tips.size(); ++k) {
    by_parameter += tips[k].by_parameter.transpose() * gradients[k];
    of_readings += std::pow(sources_.encoder, 2) * (tips[k].by_joint.transpose() * gradients[k]).squaredNorm() +
                   std::pow(sources_.probing, 2) * gradients[k].squaredNorm();
  }
  return std::sqrt(by_parameter.dot(sources_.covariance * by_parameter) + of_readings);
}

Eigen::Matrix3d UncertainArm::of_point(const UncertainTip& tip) const {
  return tip.by_parameter * sources_.covariance * tip.by_parameter.transpose() +
         std::pow(sources_.encoder, 2) * tip.by_joint * tip.by_joint.transpose() +
         std::pow(sources_.probing, 2) * Eigen::Matrix3d::Identity();
}

double UncertainArm::of_length(const UncertainTip& first, const UncertainTip& second) const {
  const Eigen::Vector3d along = (second.in_base - first.in_base).normalized();
  return of_combination(std::array{first, second}, std::array<Eigen::Vector3d, 2>{-along, along});
}

// The fit answers a change of each point along its normal: δ(centre, radius) = A⁺ δ with rows (nᵀ, 1) in A.
double UncertainArm::of_diameter(std::span<const UncertainTip> tips, const Eigen::Vector3d& centre_in_base) const {
  Eigen::MatrixX4d rows(static_cast<Eigen::Index>(tips.size()), 4);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    rows.row(k) << (tips[static_cast<std::size_t>(k)].in_base - centre_in_base).normalized().transpose(), 1.0;
  }
  const Eigen::MatrixXd answer =
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(rows).solve(Eigen::MatrixXd::Identity(rows.rows(), rows.rows()));
  std::vector<Eigen::Vector3d> gradients;
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    gradients.emplace_back(2.0 * answer(3, k) * rows.row(k).head<3>().transpose());
  }
  Eigen::VectorXd by_parameter = Eigen::VectorXd::Zero(sources_.covariance.rows());
  if (kinematics_.radius_column() >= 0) {
    by_parameter[kinematics_.radius_column()] = -2.0;
  }
  return of_combination(tips, gradients, std::move(by_parameter));
}

}  // namespace artcal
