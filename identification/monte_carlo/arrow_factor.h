#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/error.h"
#include "identification/least_squares/elimination.h"
#include "identification/least_squares/linearisation.h"

namespace artcal {

/// A triangular factor R of all unknowns of a system, sparse as eliminate_nuisance() leaves it: the rows taken out with
/// the nuisance unknowns, and the triangle of the arm's parameters. Solves with RᵀR, the normal matrix, without forming
/// it.
class ArrowFactor {
 public:
  /// No solution: some unknown or parameter is not determined. By normal equations for steps only.
  static Expected<ArrowFactor> of(const Linearisation& linearisation, Folding folding = Folding::Reflections);

  /// δ with RᵀR·δ = gradient, and |R·δ|, its length in standard deviations where weights are their inverse.
  struct Step {
    Eigen::VectorXd numbers;
    double length = 0.0;
  };
  [[nodiscard]] Step solve(const Eigen::VectorXd& gradient) const;
  /// δ of the artefact parameters and of the arm, to the last bit as solve() has it, where the gradient is zero but for
  /// the unknowns of one group. Takes time in proportion to the artefact parameters, not to the number of groups.
  [[nodiscard]] Eigen::VectorXd solve_for_common(int group, const Eigen::VectorXd& gradient_of_group) const;

  /// R⁻ᵀ·aᵀ of rows a = [the block's group | its artefact parameters | arm], a column each, without the entries that
  /// are zero: with Y of weighted rows YᵀY is their part of the hat matrix.
  [[nodiscard]] Eigen::MatrixXd half_solved(const Block& block, const Eigen::Ref<const Eigen::MatrixXd>& rows) const;
  /// R⁻¹·y of these, of the unknowns that the rows have: with half_solved() their columns of (RᵀR)⁻¹·aᵀ.
  [[nodiscard]] Eigen::MatrixXd solved(const Block& block, const Eigen::MatrixXd& half) const;
  /// The same of all unknowns that `half` reaches: of the columns of reached_by() one after the other, then the arm's.
  [[nodiscard]] Eigen::MatrixXd fully_solved(const Block& block, const Eigen::MatrixXd& half) const;

  /// Which of eliminated() a block's rows are not zero in: those of its leaf and of the interface, in this order.
  [[nodiscard]] std::vector<int> reached_by(const Block& block) const;
  [[nodiscard]] const std::vector<EliminatedRows>& eliminated() const { return eliminated_; }

  /// Diagonal of (RᵀR)⁻¹ for the artefact parameters: their variances where weights are inverse standard deviations.
  [[nodiscard]] Eigen::VectorXd parameter_variances() const;

 private:
  [[nodiscard]] std::vector<Eigen::Index> positions_of(const Block& block) const;
  void index_rows();

  StateLayout layout_;
  std::vector<EliminatedRows> eliminated_;
  std::vector<int> rows_of_;         // of each position: which eliminated rows have it among their columns
  std::vector<Eigen::Index> place_;  // and which of these columns it is
  std::vector<int> for_common_;      // eliminated rows that artefact parameters follow from
  Eigen::MatrixXd arm_;              // upper triangular
};

/// The same for a factor in parts: `rows` in the order of their elimination, and the arm's upper triangle.
ArrowFactor::Step solve_arrow(const StateLayout& layout, const std::vector<const EliminatedRows*>& rows,
                              const Eigen::MatrixXd& arm, const Eigen::VectorXd& gradient);

}  // namespace artcal
