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

/// Turns normals and directions as FitOptions::towards says. A sphere has none; a cone's points into its
/// opening and stays.
void orient(Sphere& sphere, const FitOptions& options);
void orient(Plane& plane, const FitOptions& options);
void orient(Line& line, const FitOptions& options);
void orient(Circle& circle, const FitOptions& options);
void orient(Cylinder& cylinder, const FitOptions& options);
void orient(Cone& cone, const FitOptions& options);

}  // namespace artcal::fitting
