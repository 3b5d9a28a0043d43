#pragma once

#include <optional>
#include <string_view>

#include "fitting/fit.h"

namespace artcal::segmentation {

/// Another round surface that holds the points as well as a sphere does, as far as their noise shows: "cylinder" or
/// "cone"; nothing where the sphere is the better one. A ring of a ball's diameter touches a ball all around, and a
/// narrow band or a noisy patch of one looks like both: what the points do not tell apart is not called a ball.
/// REQUIRES points on which a sphere can be fitted.
std::optional<std::string_view> other_shape(const Eigen::Matrix3Xd& points);

}  // namespace artcal::segmentation
