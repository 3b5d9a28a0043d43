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

void turn(Eigen::Vector3d& direction, const FitOptions& options) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  const double sense = options.towards ? direction.dot(*options.towards) : direction(largest);
  if (sense < 0.0) {
    direction = -direction;
  }
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

void orient(Sphere&, const FitOptions&) {}
void orient(Cone&, const FitOptions&) {}
void orient(Plane& plane, const FitOptions& options) { turn(plane.normal, options); }
void orient(Line& line, const FitOptions& options) { turn(line.direction, options); }
void orient(Circle& circle, const FitOptions& options) { turn(circle.normal, options); }
void orient(Cylinder& cylinder, const FitOptions& options) { turn(cylinder.direction, options); }

}  // namespace artcal::fitting
