#pragma once

#include <array>
#include <concepts>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/arm.h"
#include "acquisition/arm/kernels/chain.h"
#include "acquisition/arm/parameters.h"

namespace artcal {

struct WeighedChain;

/// What a pass needs to know of one reading.
struct JointReading {
  /// Sine and cosine of the joint angles, interleaved: sin q1, cos q1, sin q2, … They do not depend on the arm's
  /// parameters, so a recording computes them once and no iteration asks libm again.
  std::span<const double> sines;
  /// The angles, rad, and travels of prismatic joints, mm; arms with gains, couplings or prismatic joints need them,
  /// whole turns and all.
  std::span<const double> q;
  /// Of the arm, °C; arms that expand need it. NaN: the arm's reference.
  double temperature = std::numeric_limits<double>::quiet_NaN();

  template <typename Numbers>
  requires std::convertible_to<const Numbers&, std::span<const double>> JointReading(const Numbers& sines_of_q)
      : sines(sines_of_q) {}
  JointReading(std::span<const double> sines_of_q, std::span<const double> angles,
               double of_arm = std::numeric_limits<double>::quiet_NaN())
      : sines(sines_of_q), q(angles), temperature(of_arm) {}
};

/// Fills `sines` (2·n numbers) from joint readings `q` (n numbers, rad). Those of prismatic joints are not looked at.
void joint_sines(std::span<const double> q, std::span<double> sines);

/// The tip of an arm as a function of its joint readings, and its derivatives by every parameter, in one
/// pass out along the chain and no allocation. The arm is copied into the numbers the
/// pass needs; a ForwardKinematics is const afterwards and may be shared between threads.
///
/// Derivatives (Gao 2013 §3; domain: P the tip, p(i) the origin, x(i), y(i), z(i) the axes of frame i):
///   standard: ∂P/∂θi = z(i-1) × (P − p(i-1)),  ∂P/∂di = z(i-1),  ∂P/∂ai = x(i),
///             ∂P/∂αi = x(i) × (P − p(i)),       ∂P/∂βi = y(i) × (P − p(i))
///   modified: the same with the axes where Craig has them: α and a along x(i-1), β about the y axis
///             after both, θ and d along z(i).
///   tip:      ∂P/∂(lx, ly, lz) = x(n), y(n), z(n); ∂P/∂radius = 0.
/// An arm with joint errors (JointErrors) is swept at the angles q' that they lead to, with one or two passes more.
/// What turns a joint has the column of its θ times that turn. Where joints bend under gravity, ∂P counts the
/// change of their torque too: with φi = θi + sign·q'i the joint angles, K the compliances and B = 1 − K·∂τ/∂φ,
///             dP = ∂P + (∂P/∂φ)·B⁻¹·(∂φ + K·∂τ),  ∂ at the angles held.
class ForwardKinematics {
 public:
  /// Columns of the derivative are the `parameters`, which are parameters of the arm or a selection.
  ForwardKinematics(const Arm& arm, const std::vector<Parameter>& parameters, int probe);

  [[nodiscard]] int joint_count() const { return static_cast<int>(links_.size()); }
  [[nodiscard]] int column_count() const { return columns_; }
  /// Radius of the probe's tip, mm, and its column among the parameters, or -1.
  [[nodiscard]] double tip_radius() const { return tip_radius_; }
  [[nodiscard]] int radius_column() const { return column_radius_; }

  /// The tip's centre in the base frame, mm. REQUIRES: reading.sines.size() == 2·joint_count(); reading.q, of an arm
  /// with gains, couplings or prismatic joints or with columns for such errors.
  [[nodiscard]] Eigen::Vector3d tip_in_base(const JointReading& reading) const;

  /// The same, and its derivative by the parameters: `derivative` is 3 × column_count(), column-major,
  /// mm per unit of the parameter; columns of other probes' tips are zero.
  Eigen::Vector3d tip_in_base(const JointReading& reading, double* derivative) const;

  /// The same of up to postures_at_once readings, to the last bit, in a fraction of the time: `tips` become [3][8] and
  /// `derivative`, which may be null, [column_count()][3][8], the i-th reading's numbers at i of the eight.
  void tips_in_base(std::span<const JointReading> readings, double* tips, double* derivative) const;

  /// The same, and its derivative by the joint readings q: 3 × joint_count(), column-major, mm per rad, of a prismatic
  /// joint mm per mm.
  Eigen::Vector3d tip_by_joints(const JointReading& reading, double* derivative) const;

  /// The tip's centre and the joints' axes in the base frame: unit vectors along them and a point on each
  /// (the origins that the class comment calls p), both 3 × joint_count(), column-major.
  Eigen::Vector3d axes_in_base(const JointReading& reading, double* directions, double* points) const;

 private:
  using Link = ChainLink;
  struct LinkErrors {
    JointErrors size;
    Eigen::Vector3d weight;                      // N
    std::array<int, joint_error_kinds> columns;  // from ParameterKind::Cosine1 on
  };
  struct Frame;
  struct Frames;
  struct Posture;
  struct Slopes;
  template <typename ExpansionFactor, typename Visit>
  Eigen::Vector3d walk(const double* sines, const double* q, ExpansionFactor expansion_factor, Visit&& visit) const;

  // Of an arm with errors.
  [[nodiscard]] bool has_errors() const { return !errors_.empty(); }
  [[nodiscard]] Posture posture_of(const JointReading& reading) const;
  Eigen::Vector3d walk_frames(const Posture& posture, Frames& frames) const;
  [[nodiscard]] WeighedChain weighed(const Frames& frames, const Eigen::Vector3d& tip) const;
  [[nodiscard]] Slopes slopes_of(const Frames& frames, const WeighedChain& chain) const;
  Eigen::Vector3d put_with_errors(const JointReading& reading, double* derivative) const;
  Eigen::Vector3d put_by_joints_with_errors(const JointReading& reading, double* derivative) const;

  Convention convention_;
  std::vector<Link> links_;
  std::vector<LinkErrors> errors_;  // of all joints, or none: a rigid arm without columns for errors
  bool sags_ = false;               // a joint bends under gravity, or is asked whether it does
  double reference_temperature_;
  Eigen::Vector3d tip_in_last_;
  double tip_radius_;
  std::array<int, 3> column_tip_{-1, -1, -1};
  int column_radius_ = -1;
  int columns_;
};

}  // namespace artcal
