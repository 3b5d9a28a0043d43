#include "core/kabsch.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace artcal {

Rotation rotation_of_moment(const Eigen::Matrix3d& moment) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return {svd.matrixU() * Eigen::Vector3d(1.0, 1.0, sign).asDiagonal() * svd.matrixV().transpose(),
          svd.singularValues()};
}

Eigen::Matrix3d rotation_onto(const Eigen::Vector3d& from, const Eigen::Vector3d& onto) {
  return Eigen::Quaterniond::FromTwoVectors(from, onto).toRotationMatrix();
}

}  // namespace artcal
