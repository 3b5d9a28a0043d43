#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "identification/least_squares/elimination.h"
#include "identification/least_squares/linearisation.h"
#include "identification/monte_carlo/arrow_factor.h"

namespace artcal {

using Placement = std::pair<int, int>;  ///< indices of the artefact and of the placement, as FeatureConstraint

/// A linearisation whose blocks are each of one placement, or of none (certificates).
struct PlacedLinearisation {
  Linearisation linearisation;
  std::vector<std::optional<Placement>> places;  ///< of each block
};

/// Blocks as blocks_of(), those without a group divided by placement.
std::vector<Block> placed_blocks(const Constraints& constraints, std::vector<std::optional<Placement>>& places);

/// The normal equations of a linearisation, eliminated as eliminate_nuisance() does, of which single placements can be
/// taken out: what a placement contributes is subtracted, and only its artefact is eliminated anew. For steps, which
/// need no more than half the digits; covariances and ranks come from orthogonal factors (ArrowFactor).
class GramTree {
 public:
  /// `placed` is referred to.
  explicit GramTree(const PlacedLinearisation& placed);

  /// The factor of the rows of all other placements.
  class Without {
   public:
    [[nodiscard]] ArrowFactor::Step solve(const Eigen::VectorXd& gradient) const;
    /// Smallest singular value of the arm's parameters over the largest, all nuisance unknowns eliminated.
    [[nodiscard]] double condition() const;
    /// Of the arm's columns.
    [[nodiscard]] Eigen::MatrixXd arm_covariance() const;

   private:
    friend class GramTree;
    const StateLayout* layout_ = nullptr;
    std::vector<const EliminatedRows*> rows_;
    std::vector<std::vector<EliminatedRows>> own_;
    Eigen::MatrixXd gram_;
    Eigen::MatrixXd triangle_;
  };
  /// Nothing where these do not determine all of their unknowns.
  [[nodiscard]] std::optional<Without> without(const Placement& placement) const;

  /// Σ Jᵀr of the placement's blocks.
  [[nodiscard]] Eigen::VectorXd gradient_of(const Placement& placement) const;

 private:
  /// A component's unknowns and what they leave to the arm.
  struct Branch {
    std::vector<Eigen::Index> interface;  // positions
    std::vector<EliminatedRows> leaves;
    Eigen::MatrixXd gram;                        // of [interface | arm], the leaves eliminated
    std::vector<EliminatedRows> interface_rows;  // one or none
    Eigen::MatrixXd to_arm;
    bool regular = true;
  };
  [[nodiscard]] Branch branch(const Component& component, const Placement* without) const;
  [[nodiscard]] bool add_leaf(const std::vector<Eigen::Index>& own, const std::vector<std::size_t>& blocks,
                              const Placement* without, double sign, Branch& branch) const;
  void eliminate_interface(Branch& branch) const;
  [[nodiscard]] Branch without_leaf(std::size_t component, const Placement& placement) const;
  [[nodiscard]] bool is_of(std::size_t block, const Placement& placement) const {
    return placed_.places[block] && *placed_.places[block] == placement;
  }
  [[nodiscard]] Eigen::MatrixXd gram_of(std::size_t block) const;
  [[nodiscard]] std::vector<Eigen::Index> group_positions(int group) const;
  [[nodiscard]] std::vector<Eigen::Index> positions_of(const FeatureParameters& parameters) const;

  const PlacedLinearisation& placed_;
  Eigen::Index arm_size_;
  std::vector<Component> components_;
  std::vector<Branch> branches_;
  std::vector<int> component_of_group_;
  std::vector<std::vector<std::size_t>> by_group_;       // blocks
  std::vector<std::vector<std::size_t>> by_parameters_;  // blocks, of the first of each feature's
  Eigen::MatrixXd gram_;                                 // of the arm, all else eliminated
  bool regular_ = true;
};

}  // namespace artcal
