#pragma once

#include <type_traits>

#include "fitting/least_squares/estimate.h"
#include "fitting/options.h"

namespace artcal::fitting {

/// What is known of each feature: what it asks of points, what it can be asked for, who fits it.
template <typename F>
struct Known;
template <>
struct Known<Sphere> {
  static constexpr Requirement requirement{"sphere", 4, 3};
  static constexpr Abilities abilities{"sphere", true, true, true, true, false};
  static constexpr auto least_squares = least_squares_sphere;
};
template <>
struct Known<Plane> {
  static constexpr Requirement requirement{"plane", 3, 2};
  static constexpr Abilities abilities{"plane", true, false, false, true, true};
  static constexpr auto least_squares = least_squares_plane;
};
template <>
struct Known<Line> {
  static constexpr Requirement requirement{"line", 2, 1};
  static constexpr Abilities abilities{"line", false, false, false, false, false};
  static constexpr auto least_squares = least_squares_line;
};
template <>
struct Known<Circle> {
  static constexpr Requirement requirement{"circle", 3, 2};
  static constexpr Abilities abilities{"circle", true, true, false, true, false};
  static constexpr auto least_squares = least_squares_circle;
};
template <>
struct Known<Cylinder> {
  static constexpr Requirement requirement{"cylinder", 5, 3};
  static constexpr Abilities abilities{"cylinder", false, false, false, true, false};
  static constexpr auto least_squares = least_squares_cylinder;
};
template <>
struct Known<Cone> {
  static constexpr Requirement requirement{"cone", 6, 3};
  static constexpr Abilities abilities{"cone", false, false, false, true, false};
  static constexpr auto least_squares = least_squares_cone;
};

/// What is asked of the points: a sphere of known radius, or one that a few points bound, needs less.
template <typename F>
Requirement requirement_for(const FitOptions& options) {
  Requirement requirement = Known<F>::requirement;
  if (std::is_same_v<F, Sphere> && options.fixed_radius) {
    requirement.points = 3;
    requirement.dimensions = 2;
  } else if (options.criterion == Criterion::MinimumCircumscribed) {
    requirement.points = std::is_same_v<F, Circle> ? 3 : 2;
    requirement.dimensions = std::is_same_v<F, Circle> ? 2 : 1;
  }
  return requirement;
}

}  // namespace artcal::fitting
