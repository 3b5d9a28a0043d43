#pragma once

#include <vector>

#include <Eigen/Core>

#include "identification/least_squares/blocks.h"
#include "identification/least_squares/row_stack.h"
#include "identification/least_squares/rows.h"
#include "identification/problem/loss.h"
#include "identification/problem/system.h"

namespace artcal {

/// The rows of one block, weighted: a matrix with the block's JᵀJ, Jᵀr and rᵀr and no more rows than columns. Columns:
/// the group's unknowns, the artefact parameters, System::free, the residual.
struct BlockRows {
  int group = -1;  ///< see Block
  int unknowns = 0;
  FeatureParameters parameters;
  Eigen::MatrixXd rows;

  [[nodiscard]] int nuisance() const { return unknowns + parameters.size; }
};

/// The weighted least-squares system at one arm and its unknowns, compressed without loss: the rows of each block, and
/// where these are more than its columns, their triangle R by Householder reflections over blocks of rows
/// (TriangularFactor). With the last column z, a linear step δ leaves ½|R δ + z|² exactly as the thousand rows behind
/// it would; its singular values are the Jacobian's own, not their squares.
///
/// A robust loss enters as in iterated reweighting: the rows of each reading, and of each distance and shared number
/// whose variance Weights has, are multiplied by √ρ'(s), and what
/// the cost ½Σρ has beyond that is in a row of the residual's column only, which no step can change (ρ is
/// concave, so that ρ(s) ≥ s·ρ'(s)).
struct Linearisation {
  std::vector<BlockRows> blocks;  ///< as blocks_of()
  StateLayout layout;
};

/// The rows of one block.
Eigen::MatrixXd block_rows(const System& system, const Weights& weights, Loss loss, const Block& block,
                           const std::vector<ForwardKinematics>& kinematics_by_probe, const BlockPoint& point,
                           Folding folding = Folding::Reflections);

/// Most rows that block_rows() can have.
int max_rows(const System& system, Loss loss, const Block& block);

/// Σρ of one block: twice its cost.
double block_cost(const System& system, const Weights& weights, Loss loss, const Block& block,
                  const std::vector<ForwardKinematics>& kinematics_by_probe, const BlockPoint& point);

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
/// The same of these blocks only, such as blocks_of() divided further.
Linearisation linearise(const System& system, const Weights& weights, Loss loss, const std::vector<Block>& blocks,
                        const Arm& arm, const Unknowns& unknowns);
Linearisation linearise(const System& system, const Weights& weights, Loss loss, const std::vector<Block>& blocks,
                        const Arm& arm, const Unknowns& unknowns, Folding folding);

/// Weighted residual of what a certificate says of a shared unknown at `value`; its derivative is the weight.
inline double weighted_shared(const ArtefactParameter& shared, double weight, double value) {
  return weight * (value - shared.certified);
}

/// The triangle of the arm's parameters alone, all unknowns eliminated: at most one row a parameter.
Eigen::MatrixXd arm_triangle(const Linearisation& linearisation, int arm_size);

}  // namespace artcal
