#pragma once

#include "fitting/fit.h"

namespace artcal::segmentation {

/// Whether points that were taken for a plane lie on something curved: a piece of a large ball, of a pipe, of a cone.
/// The part of their distances that a quadratic surface explains is beyond chance (F test) and more than 0.3 % of their
/// smaller extent (standard deviation) in the plane; a plane with a certificate is not that far from flat.
bool is_curved(const Eigen::Matrix3Xd& points, const Plane& plane);

}  // namespace artcal::segmentation
