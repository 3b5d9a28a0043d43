#pragma once

#include <Eigen/Core>

namespace artcal {

/// Whether a matrix can be a covariance: finite, symmetric, every variance above zero and that of no combination below.
/// Numbers of different units may stand beside each other: each is measured in its own standard deviation. An empty one
/// can.
bool is_covariance(const Eigen::MatrixXd& matrix);

}  // namespace artcal
