#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "artefacts/simulation/virtual_arm.h"
#include "identification/planning/design_pool.h"
#include "identification/planning/goal.h"

namespace artcal {

/// Lengths in the working volume by which choices are judged, each between two postures drawn between the end stops.
struct TestLengths {
  Eigen::MatrixXd by_common;  ///< a column each: derivative by the pool's common columns, mm
  Eigen::VectorXd of_noise;   ///< variance that the noise of the two readings brings, mm²
};

TestLengths test_lengths(const VirtualArm& arm, const DesignPool& pool, const Noise& noise, int count,
                         std::uint64_t seed);

PredictedU predicted_u(const Eigen::VectorXd& variances);

/// What an exchange is to lower, mm: the mean, or for the worst the 16th root of the mean 16th power of u. It follows
/// the largest of many lengths, but not just the few that happened to be drawn.
double to_lower(const Eigen::VectorXd& variances, Goal goal);

/// Variances of the lengths where this triangle is all that is known. REQUIRES: not singular.
Eigen::VectorXd variances_of(const Eigen::MatrixXd& triangle, const TestLengths& lengths);

}  // namespace artcal
