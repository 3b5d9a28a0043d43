#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "acquisition/arm.h"
#include "acquisition/parameters.h"

/// The arm's equations a second time, so that the sweep can be held against them: 4×4 matrices multiplied
/// exactly as acquisition/arm.h writes them, for any scalar (double, long double, ceres::Jet). Nothing
/// here is taken from the sweep.
namespace artcal::testing {

template <typename T>
using Transform = Eigen::Matrix<T, 4, 4>;

/// A turn by `angle` about the axis x, y or z (0, 1, 2).
template <typename T>
Transform<T> turn(int axis, const T& angle) {
  using std::cos;
  using std::sin;
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  Transform<T> m = Transform<T>::Identity();
  m(next, next) = cos(angle);
  m(next, last) = -sin(angle);
  m(last, next) = sin(angle);
  m(last, last) = cos(angle);
  return m;
}

template <typename T>
Transform<T> slide(int axis, const T& length) {
  Transform<T> m = Transform<T>::Identity();
  m(axis, 3) = length;
  return m;
}

/// The numbers of an arm, in another scalar; `at` finds one by what it is.
template <typename T>
struct ArmNumbers {
  Convention convention;
  std::vector<T> a, d, theta, alpha, beta;
  std::vector<double> sign;
  std::vector<Eigen::Matrix<T, 3, 1>> tips;
  std::vector<T> radii;

  explicit ArmNumbers(const Arm& arm) : convention(arm.convention) {
    for (const Joint& joint : arm.joints) {
      a.push_back(T(joint.a));
      d.push_back(T(joint.d));
      theta.push_back(T(joint.theta));
      alpha.push_back(T(joint.alpha));
      beta.push_back(T(joint.beta));
      sign.push_back(joint.sign);
    }
    for (const Probe& probe : arm.probes) {
      tips.push_back(probe.tip_in_last.template cast<T>());
      radii.push_back(T(probe.radius));
    }
  }

  T& at(const Parameter& parameter) {
    const auto owner = static_cast<std::size_t>(parameter.owner);
    switch (parameter.kind) {
      case ParameterKind::A: return a[owner];
      case ParameterKind::D: return d[owner];
      case ParameterKind::Theta: return theta[owner];
      case ParameterKind::Alpha: return alpha[owner];
      case ParameterKind::Beta: return beta[owner];
      case ParameterKind::TipX: return tips[owner].x();
      case ParameterKind::TipY: return tips[owner].y();
      case ParameterKind::Radius: return radii[owner];
      case ParameterKind::TipZ: break;
    }
    return tips[owner].z();
  }
};

template <typename T>
Transform<T> base_from_last(const ArmNumbers<T>& arm, const std::vector<T>& q) {
  Transform<T> base_from_here = Transform<T>::Identity();
  for (std::size_t i = 0; i < q.size(); ++i) {
    const T theta = arm.theta[i] + T(arm.sign[i]) * q[i];
    const Transform<T> here_from_next = arm.convention == Convention::Standard
                                            ? Transform<T>(turn(2, theta) * slide(2, arm.d[i]) * slide(0, arm.a[i]) *
                                                           turn(0, arm.alpha[i]) * turn(1, arm.beta[i]))
                                            : Transform<T>(turn(0, arm.alpha[i]) * slide(0, arm.a[i]) *
                                                           turn(1, arm.beta[i]) * turn(2, theta) * slide(2, arm.d[i]));
    base_from_here = Transform<T>(base_from_here * here_from_next);
  }
  return base_from_here;
}

/// The centre of the probe's tip in the base frame, mm.
template <typename T>
Eigen::Matrix<T, 3, 1> tip_in_base(const ArmNumbers<T>& arm, const std::vector<T>& q, int probe) {
  return (base_from_last(arm, q) * arm.tips[probe].homogeneous()).template head<3>();
}

}  // namespace artcal::testing
