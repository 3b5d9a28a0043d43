#pragma once

#include <vector>

#include <Eigen/Core>

namespace artcal {

/// For every column the first one that equals it, itself where there is none before. NaN equals NaN, and -0 equals 0.
std::vector<Eigen::Index> first_coincident(const Eigen::Ref<const Eigen::MatrixXd>& columns);

}  // namespace artcal
