#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/arm.h"

namespace artcal {

/// One harmonic of an encoder's error, amplitude · sin(order · q + phase), rad.
struct Harmonic {
  double amplitude = 0.0;
  double phase = 0.0;
};

/// Amplitude (rad) of the first harmonic that a grating's eccentricity causes, read by one head: the
/// eccentricity over the grating's radius. In the field's units 412.5 · e [µm] / Ø [mm] arc seconds.
inline double eccentricity_amplitude(double eccentricity, double grating_diameter) {
  return eccentricity / (0.5 * grating_diameter);
}

/// What a joint does beside turning about its axis. Angles in rad as the encoder counts them.
struct VirtualJoint {
  std::array<Harmonic, 2> eccentricity;  ///< first and second harmonic of the encoder's error
  double compliance = 0.0;               ///< turning by torque about the axis, rad/(N·mm)
  double mass = 0.0;                     ///< of the link that the joint carries, kg
  double encoder_noise = 0.0;            ///< standard deviation of a reading, rad
  double low = -std::numbers::pi;        ///< end stops of the reading
  double high = std::numbers::pi;
};

/// An arm with all that makes it differ from the rigid chain that is identified. Its joint readings q and
/// its posture are tied by
///
///     q' = q + δ(q) + sign · k · τ(q'),    δ(q) = A1 sin(q + φ1) + A2 sin(2q + φ2)
///
/// where the rigid chain with the readings q' has the tip where the real arm has it, k is the compliance
/// and τ(q') the torque of the weight of all links further out about the joint's axis.
struct VirtualArm {
  Arm arm;  ///< true geometry, and which way is down
  std::vector<VirtualJoint> joints;

  [[nodiscard]] bool bends() const;
};

/// δ(q), rad.
double encoder_error(const VirtualJoint& joint, double q);

/// Torque of the weight about each axis, N·mm, in the axis' own sense. A link's mass sits halfway between a
/// point on its axis and one on the next (after the last: the tip); these are the frames' origins.
Eigen::VectorXd gravity_torques(const VirtualArm& arm, int probe, const Eigen::VectorXd& rigid_readings);

/// What the encoders read without noise when the rigid chain would read `rigid_readings` (q' above).
/// REQUIRES: amplitudes of at most 0.01 rad.
Eigen::VectorXd readings_of(const VirtualArm& arm, int probe, const Eigen::VectorXd& rigid_readings);

}  // namespace artcal
