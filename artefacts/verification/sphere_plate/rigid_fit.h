#pragma once

#include <Eigen/Core>

#include "core/error.h"
#include "core/rigid.h"

namespace artcal {

/// The motion that takes one set of points next to another, and what is left.
struct RigidFit {
  Rigid to_from;               ///< a proper rotation and a shift; no scale
  Eigen::Matrix3Xd residuals;  ///< to − to_from·from, mm
  double rms = 0.0;            ///< of the residual vectors' lengths, weighted, mm
  /// The scale that would fit best besides, less one: the weighted least-squares slope of `to` over the
  /// turned `from`, both from their centroids.
  double scale = 0.0;
  /// Σ w·|from − centroid|², mm²: the residuals' noise over its root is the scale's.
  double spread = 0.0;
};

/// Weighted least squares over proper rigid motions (Kabsch 1976, with the sign by Umeyama 1991): a mirrored
/// set is not turned inside out. `weights` is empty or a number above zero a point.
/// REQUIRES: as many columns in both. NoSolution where fewer than three points or all on one line.
Expected<RigidFit> fit_rigid(const Eigen::Matrix3Xd& to, const Eigen::Matrix3Xd& from,
                             const Eigen::VectorXd& weights = {});

/// The same over improper motions: how well the mirror image fits. Only its residuals and rms mean anything.
Expected<RigidFit> fit_mirrored(const Eigen::Matrix3Xd& to, const Eigen::Matrix3Xd& from);

}  // namespace artcal
