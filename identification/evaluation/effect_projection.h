#pragma once

#include <vector>

#include <Eigen/Core>

#include "identification/evaluation/effect_columns.h"
#include "identification/evaluation/score_test.h"
#include "identification/least_squares/arm_fit.h"

namespace artcal {

/// The residuals and the effects' columns with all that was fitted projected out, row by row.
struct Searched {
  Eigen::MatrixXd columns;  ///< each of length one, or zero where nothing of it is left
  Eigen::VectorXd lengths;  ///< that they had
  Eigen::VectorXd residuals;
  std::vector<ObservationRows> observations;  ///< readings, distances, certificates of what is shared
  double degrees_of_freedom = 0.0;
  /// Of each reading that was looked at, a column: what each effect does to its joint, and to the tip (x, y, z, mm).
  Eigen::MatrixXd rotations;
  Eigen::MatrixXd tips;

  [[nodiscard]] int readings() const { return static_cast<int>(rotations.cols()); }
};

/// Of more readings so many are looked at, evenly taken; of those on balls and planes, which say a third, three times
/// as many; of each feature at least ten, or all.
inline constexpr int max_searched_readings = 4000;
/// Share of a column that the fitted model must leave if anything is to be said of it.
inline constexpr double least_seen = 1e-6;

/// `system` is make_system() at the arm of the fit. Without rows where the readings looked at do not determine the arm.
Searched project_out_the_fit(const System& system, const ArmFit& fit, const EffectColumns& effects);

}  // namespace artcal
