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

}  // namespace artcal
