#pragma once

#include <optional>

#include <Eigen/Core>

namespace artcal::fitting {

/// x that minimises cost·x under A·x ≤ b, x free; none if there is no such x or no smallest. Solved in
/// exact arithmetic, so that degenerate corners (points of a regular pattern) are no special case. For
/// few variables and some dozens of rows.
std::optional<Eigen::VectorXd> minimise_linear(const Eigen::VectorXd& cost, const Eigen::MatrixXd& a,
                                               const Eigen::VectorXd& b);

}  // namespace artcal::fitting
