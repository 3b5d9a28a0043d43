#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include <Eigen/Geometry>

#include "acquisition/arm/arm.h"
#include "acquisition/arm/parameters.h"

/// The arm's equations a second time, so that the pass can be held against them: 4×4 matrices multiplied
/// exactly as acquisition/arm/arm.h writes them, for any scalar (double, long double, ceres::Jet). Nothing
/// here is taken from the pass.
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
  std::vector<double> sign, mechanical;
  std::vector<bool> slides;
  std::vector<Eigen::Matrix<T, 3, 1>> tips;
  std::vector<T> radii;
  // JointErrors, a number a joint: harmonics as cosine, sine of the first, then of the second.
  std::array<std::vector<T>, 4> harmonics;
  std::vector<T> gain, coupling, compliance, expansion;
  std::vector<double> mass;
  Eigen::Vector3d gravity;

  explicit ArmNumbers(const Arm& arm) : convention(arm.convention) {
    for (const Joint& joint : arm.joints) {
      a.push_back(T(joint.a));
      d.push_back(T(joint.d));
      theta.push_back(T(joint.theta));
      alpha.push_back(T(joint.alpha));
      beta.push_back(T(joint.beta));
      sign.push_back(joint.sign);
      mechanical.push_back(joint.mechanical_coupling);
      slides.push_back(joint.is_prismatic());
      for (std::size_t h = 0; h < 2; ++h) {
        harmonics[2 * h].push_back(T(joint.errors.cosine[h]));
        harmonics[2 * h + 1].push_back(T(joint.errors.sine[h]));
      }
      gain.push_back(T(joint.errors.gain));
      coupling.push_back(T(joint.errors.coupling));
      compliance.push_back(T(joint.errors.compliance));
      expansion.push_back(T(joint.errors.expansion));
      mass.push_back(joint.mass.value_or(0.0));
    }
    gravity = arm.gravity_in_base;
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
      case ParameterKind::Cosine1: return harmonics[0][owner];
      case ParameterKind::Sine1: return harmonics[1][owner];
      case ParameterKind::Cosine2: return harmonics[2][owner];
      case ParameterKind::Sine2: return harmonics[3][owner];
      case ParameterKind::Gain: return gain[owner];
      case ParameterKind::Coupling: return coupling[owner];
      case ParameterKind::Compliance: return compliance[owner];
      case ParameterKind::Expansion: return expansion[owner];
      case ParameterKind::TipZ: break;
    }
    return tips[owner].z();
  }
};

template <typename T>
Transform<T> base_from_last(const ArmNumbers<T>& arm, const std::vector<T>& q) {
  Transform<T> base_from_here = Transform<T>::Identity();
  for (std::size_t i = 0; i < q.size(); ++i) {
    const T moved = T(arm.sign[i]) * q[i];
    const T theta = arm.slides[i] ? arm.theta[i] : T(arm.theta[i] + moved);
    const T d = arm.slides[i] ? T(arm.d[i] + moved) : arm.d[i];
    const Transform<T> here_from_next = arm.convention == Convention::Standard
                                            ? Transform<T>(turn(2, theta) * slide(2, d) * slide(0, arm.a[i]) *
                                                           turn(0, arm.alpha[i]) * turn(1, arm.beta[i]))
                                            : Transform<T>(turn(0, arm.alpha[i]) * slide(0, arm.a[i]) *
                                                           turn(1, arm.beta[i]) * turn(2, theta) * slide(2, d));
    base_from_here = Transform<T>(base_from_here * here_from_next);
  }
  return base_from_here;
}

/// The centre of the probe's tip in the base frame, mm, where each joint turns (or slides) by q against its link.
template <typename T>
Eigen::Matrix<T, 3, 1> tip_of_angles(const ArmNumbers<T>& arm, const std::vector<T>& q, int probe) {
  return (base_from_last(arm, q) * arm.tips[probe].homogeneous()).template head<3>();
}

/// The same where q is what the joints read.
template <typename T>
Eigen::Matrix<T, 3, 1> tip_in_base(const ArmNumbers<T>& arm, const std::vector<T>& q, int probe) {
  std::vector<T> turned = q;
  for (std::size_t i = 1; i < q.size(); ++i) {
    turned[i] += T(arm.mechanical[i]) * q[i - 1];
  }
  return tip_of_angles(arm, turned, probe);
}

/// Torque of the weight of all links further out about each axis, N·mm: each pair of link and axis by itself.
template <typename T>
std::vector<T> torques_of(const ArmNumbers<T>& arm, const std::vector<T>& rigid, int probe) {
  using Vector = Eigen::Matrix<T, 3, 1>;
  const std::size_t n = rigid.size();
  const bool standard = arm.convention == Convention::Standard;
  std::vector<Vector> points, axes;
  for (std::size_t i = 0; i < n; ++i) {
    const auto inner = static_cast<std::ptrdiff_t>(standard ? i : i + 1);
    const Transform<T> frame = base_from_last(arm, std::vector<T>(rigid.begin(), rigid.begin() + inner));
    axes.push_back(frame.template block<3, 1>(0, 2));
    points.push_back(frame.template block<3, 1>(0, 3));
    if (!standard) {
      points.back() -= (arm.d[i] + (arm.slides[i] ? T(T(arm.sign[i]) * rigid[i]) : T(0.0))) *
                       axes.back();  // the axis' own origin lies before the slide along it
    }
  }
  points.push_back(tip_of_angles(arm, rigid, probe));
  std::vector<T> torques(n, T(0.0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i; j < n; ++j) {
      const Vector lever = (points[j] + points[j + 1]) * T(0.5) - points[i];
      torques[i] += axes[i].dot(lever.cross(Vector((arm.mass[j] * arm.gravity).template cast<T>())));
    }
  }
  return torques;
}

/// The tip of an arm with all its joint errors (JointErrors) when its encoders read q; `warmth` is its temperature
/// above the reference, K.
template <typename T>
Eigen::Matrix<T, 3, 1> tip_with_errors(ArmNumbers<T> arm, const std::vector<T>& q, int probe,
                                       double temperature_offset) {
  using std::cos;
  using std::sin;
  const std::size_t n = q.size();
  for (std::size_t i = 0; i < n; ++i) {
    const T expansion_factor = T(1.0) + arm.expansion[i] * T(temperature_offset);
    arm.a[i] *= expansion_factor;
    arm.d[i] *= expansion_factor;
    if (i + 1 == n) {
      arm.tips[static_cast<std::size_t>(probe)] *= expansion_factor;
    }
  }
  std::vector<T> turned = q;
  for (std::size_t i = 0; i < n; ++i) {
    turned[i] += arm.gain[i] * q[i] + (i > 0 ? (arm.coupling[i] + T(arm.mechanical[i])) * q[i - 1] : T(0.0));
    if (arm.slides[i]) {
      continue;
    }
    turned[i] += arm.harmonics[0][i] * cos(q[i]) + arm.harmonics[1][i] * sin(q[i]);
    turned[i] += arm.harmonics[2][i] * cos(T(2.0) * q[i]) + arm.harmonics[3][i] * sin(T(2.0) * q[i]);
  }
  std::vector<T> rigid = turned;
  const bool weighs = std::any_of(arm.mass.begin(), arm.mass.end(), [](double mass) { return mass > 0.0; });
  bool sags = weighs;
  if constexpr (std::is_floating_point_v<T>) {
    sags = weighs && std::any_of(arm.compliance.begin(), arm.compliance.end(), [](T k) { return k != 0; });
  }
  for (int round = 0; sags && round < 5; ++round) {
    const std::vector<T> torques = torques_of(arm, rigid, probe);
    for (std::size_t i = 0; i < n; ++i) {
      rigid[i] = turned[i] + T(arm.sign[i]) * arm.compliance[i] * torques[i];
    }
  }
  return tip_of_angles(arm, rigid, probe);
}

}  // namespace artcal::testing
