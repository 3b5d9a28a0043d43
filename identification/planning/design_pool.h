#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "artefacts/constraints/constraint.h"
#include "identification/problem/system.h"

namespace artcal {

/// Of what nothing else is known, in the solver's (physical) units, so that no choice of readings is singular.
inline constexpr double known_beforehand = 10.0;

/// A reading that could be taken: its weighted rows (one or three) by [unknowns of its placement | common columns].
struct PossibleReading {
  int reading = 0;  ///< into Recording::readings
  int feature = 0;  ///< into Constraints::features
  Eigen::MatrixXd rows;
};

/// An artefact as it could stand, and what could be read of it there.
struct PossiblePlacement {
  int placement = 0;          ///< into Recording::placements
  int unknowns = 0;           ///< its own: points, pose
  Eigen::MatrixXd certified;  ///< rows of its certified distances, the same columns
  std::vector<PossibleReading> readings;
};

/// All that could be read, linearised at one arm. Common columns are the shared unknowns of the artefacts, the errors
/// of certified distances and of the expansion of artefacts (in standard uncertainties: an error of a certificate is
/// the same in all placements, so that more placements do not make the scale better known), then the arm's free
/// parameters in the solver's physical units (1 mm, and the angle that moves the tip by 1 mm at the reach).
struct DesignPool {
  System system;
  int shared = 0;  ///< common columns before the arm's
  /// What each of these is, for a second pool with the same artefacts: "bar: A - B, 500 mm, u 0.0003 mm".
  std::vector<std::string> shared_names;
  std::vector<PossiblePlacement> placements;
  /// Triangle of what holds before anything of the pool is read: what certificates say of the shared unknowns, and
  /// that every other common number is known to 10 units beforehand, so that no choice, however small, is singular.
  Eigen::MatrixXd known;

  [[nodiscard]] int common() const { return shared + system.arm_size(); }
};

/// Noise must be stated: readings are worth what it says. No solution: the unknowns cannot be settled.
Expected<DesignPool> design_pool(const Recording& possible, const Constraints& constraints, const Arm& arm,
                                 const std::vector<Parameter>& free, const Noise& noise);

/// What reading `chosen` (into PossiblePlacement::readings) of a placement tells of the common columns, its own
/// unknowns eliminated: a triangle.
Eigen::MatrixXd information_of(const PossiblePlacement& placement, const std::vector<int>& chosen, int common);

/// The triangle of both.
Eigen::MatrixXd together(const Eigen::MatrixXd& triangle, const Eigen::MatrixXd& more);

}  // namespace artcal
