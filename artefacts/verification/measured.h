#pragma once

#include <string>

#include <Eigen/Core>

#include "artefacts/verification/point_scatter.h"
#include "artefacts/verification/session.h"
#include "core/error.h"

namespace artcal {

/// A ball or a seat as the arm measured it.
struct MeasuredPoint {
  Eigen::Vector3d centre_in_base = Eigen::Vector3d::Zero();
  double diameter = 0.0;  ///< of a ball, mm, the tip taken off; 0 for a seat
  double form = 0.0;      ///< range of the residuals, mm
  double form_95 = 0.0;   ///< range of the narrowest 95 % of a ball's residuals, mm
  PointKind kind = PointKind::TouchedBall;
  /// (JᵀJ)⁻¹ of the centre and, of a ball, its radius: their covariance over the variance of one touch.
  Eigen::Matrix4d cofactor = Eigen::Matrix4d::Zero();
  double squares = 0.0;        ///< sum of the squared residuals, mm²
  int degrees_of_freedom = 0;  ///< of them
};

/// A ball by least squares (radius free, tip radius taken off), a seat by the mean of its readings. Errors:
/// what the fit says; readings that lie on no one ball; readings of tips of several radii; a feature that is
/// neither.
Expected<MeasuredPoint> measure(const Session& session, const Touched& touched);

/// Standard deviation of the centre along a unit direction, over that of one touch.
double dilution_along(const MeasuredPoint& measured, const Eigen::Vector3d& direction);

/// "ball 3, placement A, repeat 2": for messages.
std::string text_of(const Touched& touched, const Session& session);

}  // namespace artcal
