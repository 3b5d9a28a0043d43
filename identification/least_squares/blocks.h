#pragma once

#include <vector>

#include <Eigen/Core>

#include "artefacts/constraints/constraint.h"

namespace artcal {

struct Unknowns;  // identification/problem/system.h

/// Adjacent entries of Constraints::shared that belong to one feature of an artefact, and so enter its residuals
/// together.
struct FeatureParameters {
  int first = 0;  ///< into Constraints::shared
  int size = 0;   ///< 0: none
};

/// Residuals that depend on the same nuisance unknowns: at most one group of unknowns and at most the artefact
/// parameters of one feature. Their Jacobian has no other nuisance columns, which keeps an artefact of many uncertain
/// features sparse.
struct Block {
  int group = -1;                ///< into Constraints::groups, or -1
  int unknowns = 0;              ///< size of its group; 0 without one
  FeatureParameters parameters;  ///< of the artefact
  bool has_certificate = false;  ///< what the certificate states of these parameters counts here
  std::vector<int> features{};   ///< into Constraints::features
  std::vector<int> distances{};  ///< into Constraints::distances, binding ones

  [[nodiscard]] int nuisance() const { return unknowns + parameters.size; }
};

/// First the residuals without nuisance unknowns (there may be none), then those of each group in order, then the
/// certificates of artefact parameters.
std::vector<Block> blocks_of(const Constraints& constraints);

/// Positions in one vector of all unknowns: those of each group, the artefact parameters, then the arm's x.
struct StateLayout {
  std::vector<Eigen::Index> groups;  ///< where each begins; as Constraints::groups
  Eigen::Index common = 0;           ///< where the artefact parameters begin; the arm follows them
  Eigen::Index arm = 0;
  Eigen::Index size = 0;
};
StateLayout layout_of(const Constraints& constraints, int arm_size);

/// Unknowns and the arm's x as one vector. REQUIRES: x.size() == layout.size - layout.arm.
Eigen::VectorXd packed(const StateLayout& layout, const Unknowns& unknowns, const Eigen::VectorXd& x);
/// Puts a vector's unknowns into `unknowns`, which have their sizes and references already.
void unpack(const StateLayout& layout, const Eigen::VectorXd& numbers, Unknowns& unknowns);

}  // namespace artcal
