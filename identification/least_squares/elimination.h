#pragma once

#include <vector>

#include <Eigen/Core>

#include "identification/least_squares/linearisation.h"

namespace artcal {

/// Unknowns that readings tie together otherwise than by the arm: the groups of an artefact's placements and the
/// parameters of its features. Its first unknowns (`leaves`) have no rows in common with one another and are eliminated
/// one by one; the others, which are fewer, are the interface, eliminated together afterwards.
struct Component {
  bool groups_are_leaves = true;  ///< or else the parameters are
  std::vector<int> groups;        ///< into Constraints::groups
  std::vector<FeatureParameters> parameters;
};

/// Of all unknowns, in the order of the groups. Of a plate of many balls in few placements the balls are the leaves, of
/// an artefact in many placements the placements are: the smaller side remains.
std::vector<Component> components_of(const std::vector<BlockRows>& blocks);

/// Rows that determine some unknowns, given what remains: own·δ(columns) + by_rest·δ(rest) + by_trailing·δ(trailing).
struct EliminatedRows {
  std::vector<Eigen::Index> columns;  ///< positions as StateLayout
  std::vector<Eigen::Index> rest;
  Eigen::MatrixXd own;  ///< upper triangular; fewer rows than columns where these are not determined
  Eigen::MatrixXd by_rest;
  Eigen::MatrixXd by_trailing;
};

/// The triangle of the first `trailing` columns after the nuisance unknowns, these projected out by Householder
/// reflections: its singular values are those of the Jacobian, unless `folding` says that what is left of all blocks
/// may go by normal equations. The nuisance unknowns may be rank deficient. `eliminated` may receive the rows taken out
/// on the way, in order.
Eigen::MatrixXd eliminate_nuisance(const Linearisation& linearisation, int trailing,
                                   std::vector<EliminatedRows>* eliminated = nullptr,
                                   Folding folding = Folding::Reflections);

}  // namespace artcal
