#pragma once

#include <Eigen/Core>

namespace artcal {

/// The turning that takes one set of points next to another.
struct Rotation {
  Eigen::Matrix3d rotation;  ///< proper: a mirrored set is not turned inside out
  Eigen::Vector3d shares;    ///< singular values of the moment, largest first: the second is zero for points on a line
};

/// The rotation that maximises the trace of rotationᵀ · moment, moment = Σ w · to · fromᵀ of points about their
/// centroids (Kabsch 1976, with the sign by Umeyama 1991).
Rotation rotation_of_moment(const Eigen::Matrix3d& moment);

/// The shortest turning that takes the direction `from` to that of `onto`, neither of them zero. The one place where
/// Eigen's templates for it are compiled, which takes three seconds.
Eigen::Matrix3d rotation_onto(const Eigen::Vector3d& from, const Eigen::Vector3d& onto);

}  // namespace artcal
