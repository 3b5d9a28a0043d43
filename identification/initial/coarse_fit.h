#pragma once

#include "identification/problem/system.h"

namespace artcal {

/// Radius of a ball and of the tip that touches it, mm: how far the tip is from the ball's centre. A ball of unknown
/// radius counts as one of 12.7 mm.
double distance_to_centre(const OnBall& ball, double tip_radius);

/// Gives each ball's readings a probe so long that its tip is at the ball's centre if the stylus points there.
/// `constraints` have the balls that are points (balls_as_points()) in those of `system`.
void lengthen_to_centres(const Constraints& constraints, System& system);

/// Standard deviation of a centre that is taken to lie along the stylus or at the tip, mm; at least 1.
double centre_deviation(const Constraints& constraints, const Arm& arm);

/// Weights of a fit whose readings are off by `sigma` (mm) because of the arm: what is certified counts by no more than
/// the readings on it. Held to a micrometre, more distances than the centres on a line need are a valley that is flat
/// across and takes twice the steps.
Weights coarse_weights(const Constraints& constraints, double sigma);

}  // namespace artcal
