#include "fitting/tip.h"

#include <cmath>

#include <fmt/format.h>

namespace artcal::fitting {
namespace {

Expected<void> shrink(double& radius, double offset) {
  if (!(radius - offset > 0.0)) {
    return no_solution(
        fmt::format("the tip's centres lie on a radius of {:.6g} mm, which leaves nothing of the "
                    "surface under a tip of {:.6g} mm; is the tip radius right, and the side?",
                    radius, std::abs(offset)));
  }
  radius -= offset;
  return {};
}

}  // namespace

double tip_offset(const FitOptions& options) {
  return options.side == Side::Outside ? options.tip_radius : -options.tip_radius;
}

Expected<void> take_tip_off(Sphere& sphere, const FitOptions& options) {
  return shrink(sphere.radius, tip_offset(options));
}

Expected<void> take_tip_off(Circle& circle, const FitOptions& options) {
  return shrink(circle.radius, tip_offset(options));
}

Expected<void> take_tip_off(Cylinder& cylinder, const FitOptions& options) {
  return shrink(cylinder.radius, tip_offset(options));
}

// The offset of a cone is a cone of the same axis and angle; across the axis the tip reaches r / cos ψ.
Expected<void> take_tip_off(Cone& cone, const FitOptions& options) {
  return shrink(cone.radius, tip_offset(options) / std::cos(cone.half_angle));
}

Expected<void> take_tip_off(Plane& plane, const FitOptions& options) {
  plane.point -= options.tip_radius * plane.normal;
  return {};
}

Expected<void> take_tip_off(Line&, const FitOptions&) { return {}; }

Eigen::Vector3d* turnable(Sphere&) { return nullptr; }
Eigen::Vector3d* turnable(Cone&) { return nullptr; }
Eigen::Vector3d* turnable(Plane& plane) { return &plane.normal; }
Eigen::Vector3d* turnable(Line& line) { return &line.direction; }
Eigen::Vector3d* turnable(Circle& circle) { return &circle.normal; }
Eigen::Vector3d* turnable(Cylinder& cylinder) { return &cylinder.direction; }

bool points_away(const Eigen::Vector3d& direction, const FitOptions& options) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return (options.towards ? direction.dot(*options.towards) : direction(largest)) < 0.0;
}

}  // namespace artcal::fitting
