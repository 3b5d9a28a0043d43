#pragma once

#include <vector>

#include <Eigen/Core>

#include "identification/loss.h"
#include "identification/system.h"

namespace artcal {

/// The weighted least-squares system at one arm and its unknowns, compressed without loss: for the
/// readings of each group of unknowns the triangle R of [by unknowns | by arm | residuals], from
/// Householder reflections over blocks of rows (TriangularFactor). With the last column z, a linear step δ
/// of the unknowns and the arm leaves ½|R δ + z|² exactly as the thousand rows behind it would; its
/// singular values are the Jacobian's own, not their squares.
///
/// A robust loss enters as in iterated reweighting: the rows of each reading, and of each distance and shared number
/// whose variance Weights has, are multiplied by √ρ'(s), and what
/// the cost ½Σρ has beyond that is added to the last diagonal element, which no step can change (ρ is
/// concave, so that ρ(s) ≥ s·ρ'(s)).
struct Linearisation {
  /// First the readings that have no unknowns of their own, and what certificates say of the shared ones; then
  /// each group of Constraints::groups. Square, upper triangular; columns: the group's unknowns, the shared
  /// ones, System::free, the residual.
  std::vector<Eigen::MatrixXd> triangles;
  int shared = 0;  ///< columns of shared unknowns
};

/// Readings and distances of one block of a Linearisation, index 0 being those without unknowns of their own.
struct Block {
  int unknowns = 0;            ///< size of its group
  bool has_shared = false;     ///< what certificates say of the shared unknowns counts here
  std::vector<int> features;   ///< into Constraints::features
  std::vector<int> distances;  ///< into Constraints::distances, binding ones
};
std::vector<Block> blocks_of(const Constraints& constraints);

/// Where a block is taken: its group's reference and values, and those of the shared unknowns.
struct BlockPoint {
  const GroupReference& reference;
  const double* values = nullptr;
  const double* shared = nullptr;
};

/// The triangle of one block.
Eigen::MatrixXd block_triangle(const System& system, const Weights& weights, Loss loss, const Block& block,
                               const std::vector<Sweep>& sweeps, const BlockPoint& point);

/// Σρ of one block: twice its cost.
double block_cost(const System& system, const Weights& weights, Loss loss, const Block& block,
                  const std::vector<Sweep>& sweeps, const BlockPoint& point);

/// Sum of squares that a loss expects of a reading's weighted residual (see loss_of()).
inline double expected_square(const FeatureWeights& weights, int reading, int dimension) {
  return weights.variance.empty() ? dimension : dimension * weights.variance[static_cast<std::size_t>(reading)];
}

/// Whether a loss is applied to distances and to shared numbers.
inline bool loss_reaches_distances(Loss loss, const Weights& weights) {
  return loss != Loss::None && !weights.distance_variance.empty();
}
inline bool loss_reaches_shared(Loss loss, const Weights& weights) {
  return loss != Loss::None && !weights.shared_variance.empty();
}

Linearisation linearise(const System& system, const Weights& weights, Loss loss, const Arm& arm,
                        const Unknowns& unknowns);

/// Weighted residual of what a certificate says of a shared unknown at `value`; its derivative is the weight.
inline double weighted_shared(const SharedUnknown& shared, double weight, double value) {
  return weight * (value - shared.certified);
}

/// The triangle of [shared unknowns | arm's parameters], the groups' unknowns eliminated.
Eigen::MatrixXd common_triangle(const Linearisation& linearisation, int arm_size);

/// The triangle of the arm's parameters alone, all unknowns eliminated: at most one row a parameter.
Eigen::MatrixXd arm_triangle(const Linearisation& linearisation, int arm_size);

/// The same system with only some of the arm's parameters, by index.
Linearisation with_parameters(const Linearisation& linearisation, int arm_size, const std::vector<int>& kept);

}  // namespace artcal
