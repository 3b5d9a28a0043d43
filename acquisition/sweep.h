#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm.h"
#include "acquisition/parameters.h"

namespace artcal {

/// Sine and cosine of a reading's joint angles, interleaved: sin q1, cos q1, sin q2, … They do not
/// depend on the arm's parameters, so a recording computes them once and no iteration asks libm again.
using JointSines = std::span<const double>;

/// Fills `sines` (2·n numbers) from joint readings `q` (n numbers, rad).
void joint_sines(std::span<const double> q, std::span<double> sines);

/// The tip of an arm as a function of its joint readings, and its derivatives by every structural
/// parameter, in one pass out along the chain and no allocation. The arm is copied into the numbers the
/// pass needs; a Sweep is const afterwards and may be shared between threads.
///
/// Derivatives (Gao 2013 §3; domain: P the tip, p(i) the origin, x(i), y(i), z(i) the axes of frame i):
///   standard: ∂P/∂θi = z(i-1) × (P − p(i-1)),  ∂P/∂di = z(i-1),  ∂P/∂ai = x(i),
///             ∂P/∂αi = x(i) × (P − p(i)),       ∂P/∂βi = y(i) × (P − p(i))
///   modified: the same with the axes where Craig has them: α and a along x(i-1), β about the y axis
///             after both, θ and d along z(i).
///   tip:      ∂P/∂(lx, ly, lz) = x(n), y(n), z(n); ∂P/∂radius = 0.
class Sweep {
 public:
  /// Columns of the derivative are the `parameters`, which are parameters_of(arm) or a selection.
  Sweep(const Arm& arm, const std::vector<Parameter>& parameters, int probe);

  [[nodiscard]] int joint_count() const { return static_cast<int>(links_.size()); }
  [[nodiscard]] int column_count() const { return columns_; }
  /// Radius of the probe's tip, mm, and its column among the parameters, or -1.
  [[nodiscard]] double tip_radius() const { return tip_radius_; }
  [[nodiscard]] int radius_column() const { return column_radius_; }

  /// The tip's centre in the base frame, mm. REQUIRES: sines.size() == 2·joint_count().
  [[nodiscard]] Eigen::Vector3d tip_in_base(JointSines sines) const;

  /// The same, and its derivative by the parameters: `derivative` is 3 × column_count(), column-major,
  /// mm per mm or mm per rad; columns of other probes' tips are zero.
  Eigen::Vector3d tip_in_base(JointSines sines, double* derivative) const;

  /// The same, and its derivative by the joint readings q: 3 × joint_count(), column-major, mm per rad.
  Eigen::Vector3d tip_by_joints(JointSines sines, double* derivative) const;

  /// The tip's centre and the joints' axes in the base frame: unit vectors along them and a point on each
  /// (the origins that the class comment calls p), both 3 × joint_count(), column-major.
  Eigen::Vector3d axes_in_base(JointSines sines, double* directions, double* points) const;

 private:
  struct Link {
    double a, d, sign;
    double sin_theta, cos_theta;  // of the zero offset
    double sin_alpha, cos_alpha;
    double sin_beta, cos_beta;
    bool has_beta;
    // Column of each parameter in the derivative, or -1.
    int column_a, column_d, column_theta, column_alpha, column_beta;
  };
  struct Frame;
  template <typename Visit>
  Eigen::Vector3d walk(JointSines sines, Visit&& visit) const;

  Convention convention_;
  std::vector<Link> links_;
  Eigen::Vector3d tip_in_last_;
  double tip_radius_;
  std::array<int, 3> column_tip_{-1, -1, -1};
  int column_radius_ = -1;
  int columns_;
};

}  // namespace artcal
