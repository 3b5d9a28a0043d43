#pragma once

#include "fitting/fit.h"

namespace artcal::fitting {

/// The surface that a tip touched, from the one its centres lie on: offset by the tip radius towards the
/// material. NoSolution where nothing is left of it, which means a wrong radius or the wrong side.
Expected<void> take_tip_off(Sphere& sphere, const FitOptions& options);
Expected<void> take_tip_off(Plane& plane, const FitOptions& options);  ///< REQUIRES: normal towards the probe
Expected<void> take_tip_off(Circle& circle, const FitOptions& options);
Expected<void> take_tip_off(Cylinder& cylinder, const FitOptions& options);
Expected<void> take_tip_off(Cone& cone, const FitOptions& options);
Expected<void> take_tip_off(Line& line, const FitOptions& options);  ///< has no surface: nothing to do

/// Distance from the axis or centre to the tip's centres, less that to the surface, mm.
double tip_offset(const FitOptions& options);

/// The normal or direction that FitOptions::towards turns, or none: a sphere has none, and a cone's points
/// into its opening.
Eigen::Vector3d* turnable(Sphere& sphere);
Eigen::Vector3d* turnable(Plane& plane);
Eigen::Vector3d* turnable(Line& line);
Eigen::Vector3d* turnable(Circle& circle);
Eigen::Vector3d* turnable(Cylinder& cylinder);
Eigen::Vector3d* turnable(Cone& cone);

/// Whether a direction points the wrong way.
bool points_away(const Eigen::Vector3d& direction, const FitOptions& options);

}  // namespace artcal::fitting
