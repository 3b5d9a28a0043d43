#pragma once

#include <string>

#include <Eigen/Core>

#include "artefacts/verification/session.h"
#include "core/error.h"

namespace artcal {

/// A ball or a seat as the arm measured it.
struct MeasuredPoint {
  Eigen::Vector3d centre_in_base = Eigen::Vector3d::Zero();
  double diameter = 0.0;  ///< of a ball, mm, the tip taken off; 0 for a seat
  double form = 0.0;      ///< range of the residuals, mm
  double form_95 = 0.0;   ///< range of the narrowest 95 % of a ball's residuals, mm
  double u = 0.0;         ///< standard uncertainty of a coordinate by the scatter of its points, mm; 0: not told
};

/// A ball by least squares (radius free, tip radius taken off), a seat by the mean of its readings. Errors:
/// what the fit says; readings that lie on no one ball; readings of tips of several radii; a feature that is
/// neither.
Expected<MeasuredPoint> measure(const Session& session, const Touched& touched);

/// "ball 3, placement A, repeat 2": for messages.
std::string text_of(const Touched& touched, const Session& session);

}  // namespace artcal
