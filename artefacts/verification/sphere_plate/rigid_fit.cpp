#include "artefacts/verification/sphere_plate/rigid_fit.h"

#include <cassert>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "core/kabsch.h"

namespace artcal {

Expected<RigidFit> fit_rigid(const Eigen::Matrix3Xd& to, const Eigen::Matrix3Xd& from, const Eigen::VectorXd& weights) {
  assert(to.cols() == from.cols());
  const Eigen::VectorXd w = weights.size() == 0 ? Eigen::VectorXd(Eigen::VectorXd::Ones(to.cols())) : weights;
  const double total = w.sum();
  if (to.cols() < 3) {
    return no_solution("a pose needs at least three points, not on one line");
  }
  const Eigen::Vector3d to_centroid = to * w / total;
  const Eigen::Vector3d from_centroid = from * w / total;
  const Eigen::Matrix3Xd a = to.colwise() - to_centroid;
  const Eigen::Matrix3Xd b = from.colwise() - from_centroid;
  const Eigen::Vector3d shape = Eigen::JacobiSVD<Eigen::Matrix3d>(b * w.asDiagonal() * b.transpose()).singularValues();
  if (!(shape(1) > 1e-12 * shape(0))) {
    return no_solution("the points of a pose lie on one line, so that its turning about that line is not determined");
  }
  RigidFit fit;
  fit.to_from.rotation = rotation_of_moment(a * w.asDiagonal() * b.transpose()).rotation;
  fit.to_from.translation = to_centroid - fit.to_from.rotation * from_centroid;
  const Eigen::Matrix3Xd turned = fit.to_from.rotation * b;
  fit.residuals = a - turned;
  fit.rms = std::sqrt(fit.residuals.colwise().squaredNorm().dot(w) / total);
  fit.spread = b.colwise().squaredNorm().dot(w);
  fit.scale = (fit.residuals.cwiseProduct(turned)).colwise().sum().dot(w) / fit.spread;
  return fit;
}

Expected<RigidFit> fit_mirrored(const Eigen::Matrix3Xd& to, const Eigen::Matrix3Xd& from) {
  return fit_rigid(to, Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal() * from);
}

}  // namespace artcal
