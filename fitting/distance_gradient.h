#pragma once

#include <Eigen/Core>

#include "fitting/feature.h"

namespace artcal::fitting {

/// ∂signed_distance(feature, p)/∂feature.parameters(). Directions are turned, not lengthened: only the part of the
/// derivative across a direction has a meaning. Zero where the distance has no derivative (on an axis, on the curve).
template <typename F>
using DistanceGradient = Eigen::Matrix<double, F::parameter_count, 1>;

DistanceGradient<Sphere> distance_gradient(const Sphere& sphere, const Eigen::Vector3d& p);
DistanceGradient<Plane> distance_gradient(const Plane& plane, const Eigen::Vector3d& p);
DistanceGradient<Line> distance_gradient(const Line& line, const Eigen::Vector3d& p);
DistanceGradient<Circle> distance_gradient(const Circle& circle, const Eigen::Vector3d& p);
DistanceGradient<Cylinder> distance_gradient(const Cylinder& cylinder, const Eigen::Vector3d& p);
DistanceGradient<Cone> distance_gradient(const Cone& cone, const Eigen::Vector3d& p);

}  // namespace artcal::fitting
