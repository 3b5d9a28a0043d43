#pragma once

#include "fitting/cloud.h"
#include "fitting/least_squares/round_state.h"

namespace artcal::fitting {

/// Models for `minimise`. The gradient ∇d of the distance at a point p gives every column: moving the
/// surface point by t changes d by −∇d·t, turning the surface about it by ω changes d by −((p − o) × ∇d)·ω;
/// the bending columns stand beside each model. tests/fitting checks each against differences.

/// Steps are as long as the largest of them, curvatures counted by what they do to the feature's size.
inline double bent(double change, double curvature) { return change / std::max(1.0, std::abs(curvature)); }

/// [∂d/∂(along N, turn about b, turn about g, κ) | d]; a known radius drops κ.
template <bool FixedRadius>
struct SphereModel {
  using State = RoundState;
  static constexpr int size = FixedRadius ? 3 : 4;
  using Step = Eigen::Matrix<double, size, 1>;
  const Cloud& cloud;

  template <typename Add>
  void rows(const State& s, Add&& add) const {
    const double k = s.curvature;
    for (Eigen::Index i = 0; i < cloud.size(); ++i) {
      const Eigen::Vector3d q = s.frame.transpose() * (cloud.points.col(i) - s.point);
      const double across = std::hypot(q.y(), q.z());
      const SectionDistance d = section_distance(k, q.x(), across);
      Eigen::Matrix<double, 1, size + 1> row;
      // Turning about o moves the centre at arm 1/k: (q × ∇d) with ∇d = (k·q + N)/w is q × N / w.
      row(0) = -d.ux;
      row(1) = -q.z() / d.w;
      row(2) = q.y() / d.w;
      if constexpr (!FixedRadius) {
        row(3) = d.bend / d.w;
      }
      row(size) = d.distance;
      add(cloud.root_weight(i) * row);
    }
  }
  [[nodiscard]] State moved(const State& s, const Step& step) const {
    State next = s;
    next.point += step(0) * s.frame.col(0);
    next.frame = turned(s.frame, {0.0, step(1), step(2)});
    if constexpr (!FixedRadius) {
      next.curvature += step(3);
    }
    return next;
  }
  [[nodiscard]] double length_of(const State& s, const Step& step) const {
    const double bend = FixedRadius ? 0.0 : bent(step(size - 1), s.curvature);
    return std::max(step.template head<3>().cwiseAbs().maxCoeff(), std::abs(bend));
  }
};

/// [∂d/∂(along N, turn about N, b, g, κ, μ) | d]; a cylinder drops μ.
///   d = cos ψ·D − sin ψ·h;  ∂d/∂κ = T·(cos²ψ/w + sin²ψ + sin ψ·cos ψ·k·h/w),
///   ∂d/∂μ = T·cos ψ·(sin ψ/w − sin ψ − cos ψ·k·h/w)   (the ruling through o stays where it is).
template <bool Tapered>
struct AxialModel {
  using State = RoundState;
  static constexpr int size = Tapered ? 6 : 5;
  using Step = Eigen::Matrix<double, size, 1>;
  const Cloud& cloud;

  template <typename Add>
  void rows(const State& s, Add&& add) const {
    const auto [k, sine, cosine, axes] = s.section();
    const Eigen::Vector3d normal{cosine, 0.0, -sine};
    const Eigen::Vector3d ruling{sine, 0.0, cosine};
    for (Eigen::Index i = 0; i < cloud.size(); ++i) {
      const Eigen::Vector3d q = axes.transpose() * (cloud.points.col(i) - s.point);
      const SectionDistance d = section_distance(k, q.x(), q.y());
      const Eigen::Vector3d gradient{cosine * d.ux, cosine * d.uy, -sine};
      const Eigen::Vector3d torque = q.cross(gradient);
      const double lean = cosine * k * q.z() / d.w;
      Eigen::Matrix<double, 1, size + 1> row;
      row(0) = -gradient.dot(normal);
      row(1) = -torque.dot(normal);
      row(2) = -torque.y();
      row(3) = -torque.dot(ruling);
      row(4) = d.bend * (cosine * cosine / d.w + sine * (sine + lean));
      if constexpr (Tapered) {
        row(5) = d.bend * cosine * (sine / d.w - sine - lean);
      }
      row(size) = cosine * d.distance - sine * q.z();
      add(cloud.root_weight(i) * row);
    }
  }
  [[nodiscard]] State moved(const State& s, const Step& step) const {
    State next = s;
    next.point += step(0) * s.frame.col(0);
    next.frame = turned(s.frame, step.template segment<3>(1));
    next.curvature += step(4);
    if constexpr (Tapered) {
      next.taper += step(5);
    }
    return next;
  }
  [[nodiscard]] double length_of(const State& s, const Step& step) const {
    const double k = std::hypot(s.curvature, s.taper);
    double longest = step.template head<4>().cwiseAbs().maxCoeff();
    for (int j = 4; j < size; ++j) {
      longest = std::max(longest, std::abs(bent(step(j), k)));
    }
    return longest;
  }
};

/// A circle: N radial, b along the curve, g the circle's normal. Projected: [∂D/∂(along N, turn about g,
/// κ) | D]. Spatial adds the height over the plane as a second row and the three motions that change it.
template <bool Spatial>
struct CircleModel {
  using State = RoundState;
  static constexpr int size = Spatial ? 6 : 3;
  using Step = Eigen::Matrix<double, size, 1>;
  const Cloud& cloud;

  template <typename Add>
  void rows(const State& s, Add&& add) const {
    for (Eigen::Index i = 0; i < cloud.size(); ++i) {
      const Eigen::Vector3d q = s.frame.transpose() * (cloud.points.col(i) - s.point);
      const SectionDistance d = section_distance(s.curvature, q.x(), q.y());
      Eigen::Matrix<double, 1, size + 1> row;
      row(0) = -d.ux;
      row(1) = q.y() / d.w;
      row(2) = d.bend / d.w;
      if constexpr (Spatial) {
        row.template segment<3>(3) << 0.0, q.z() * d.uy, -q.z() * d.ux;
      }
      row(size) = d.distance;
      add(cloud.root_weight(i) * row);
      if constexpr (Spatial) {
        row << 0.0, 0.0, 0.0, -1.0, -q.y(), q.x(), q.z();
        add(cloud.root_weight(i) * row);
      }
    }
  }
  [[nodiscard]] State moved(const State& s, const Step& step) const {
    State next = s;
    next.point += step(0) * s.frame.col(0);
    Eigen::Vector3d rotation{0.0, 0.0, step(1)};
    if constexpr (Spatial) {
      next.point += step(3) * s.frame.col(2);
      rotation.head<2>() = step.template segment<2>(4);
    }
    next.frame = turned(s.frame, rotation);
    next.curvature += step(2);
    return next;
  }
  [[nodiscard]] double length_of(const State& s, const Step& step) const {
    Step scaled = step;
    scaled(2) = bent(step(2), s.curvature);
    return scaled.cwiseAbs().maxCoeff();
  }
};

}  // namespace artcal::fitting
