#pragma once

#include "identification/problem/system.h"

namespace artcal {

class FeatureResidual;  // identification/least_squares/residual.h

/// Weights where nothing is known of the noise: a reading's coordinate counts 1 (per mm), a certified
/// distance or what is shared as much as the readings that see it, √(number of readings).
Weights unit_weights(const Constraints& constraints);

/// Weights for one noise of `sigma` mm in every coordinate: a reading counts 1/√(σ² + u²), u being what its
/// measured length or coordinates are uncertain by; a distance or what is shared 1/u.
Weights uniform_weights(const Constraints& constraints, double sigma);

/// Weights for `encoder` noise (rad, every joint alone) and `probing` noise (mm, every coordinate): a
/// reading's covariance at its posture is probing²·1 + encoder²·Σ g gᵀ, g the tip's motion by a joint.
/// Readings with a long lever count less, and less across it than along it.
Weights posture_weights(const System& system, const Arm& arm, const Unknowns& unknowns, double encoder, double probing);
/// Those of one feature, with the residual that it has there.
FeatureWeights posture_weights(const System& system, const FeatureConstraint& feature, const FeatureResidual& residual,
                               const std::vector<ForwardKinematics>& kinematics_by_probe, const Arm& arm,
                               double encoder, double probing);

/// The weights to begin with for a noise that is given in one way or the other, or not at all.
Weights first_weights(const System& system, const Arm& arm, const Unknowns& unknowns, const Noise& noise);

/// The noise of a coordinate that weights stand for, mm; the median where it depends on the posture.
double typical_noise(const Weights& weights);

}  // namespace artcal
