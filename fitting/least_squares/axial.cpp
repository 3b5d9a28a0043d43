#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "fitting/least_squares/axis_start.h"
#include "fitting/least_squares/estimate.h"
#include "fitting/least_squares/round_models.h"

namespace artcal::fitting {
namespace {

constexpr Eigen::Index start_points = 120;  // enough to tell one valley from another
constexpr int start_count = 12;

// The axis: a point abreast of the centroid (the cloud's origin), the direction, radius and opening there.
// A negative curvature means that the frame's normal points inwards; both signs name the same surface. The
// half angle keeps its sign: below zero the cone opens against the direction.
Cone cone_of(const RoundState& state) {
  const auto [k, sine, cosine, axes] = state.section();
  const Eigen::Vector3d direction = axes.col(2);
  const Eigen::Vector3d centre = state.point - axes.col(0) / k;
  const double height = -centre.dot(direction);
  const double side = k < 0.0 ? -1.0 : 1.0;
  const double angle = side * std::atan2(sine, cosine);
  return {centre + height * direction, direction, side / k + height * std::tan(angle), angle};
}

// Turned so that it opens along its direction. Last: a derivative at an angle of zero must see its sign.
void open_forwards(Estimate<Cone>& estimate) {
  if (estimate.feature.half_angle >= 0.0) {
    return;
  }
  Eigen::Matrix<double, 8, 1> sense = Eigen::Matrix<double, 8, 1>::Ones();
  sense.segment<3>(3).setConstant(-1.0);
  sense(7) = -1.0;
  estimate.feature.direction = -estimate.feature.direction;
  estimate.feature.half_angle = -estimate.feature.half_angle;
  if (estimate.covariance) {
    *estimate.covariance = (sense.asDiagonal() * *estimate.covariance * sense.asDiagonal()).eval();
  }
}

// The same surface, its point where the axis meets the plane across the base's axis at the base's point:
// that is how a covariance lets the point move, across the axis and not along it.
Cone abreast(Cone cone, const Cone& base) {
  const double along = base.direction.dot(base.point - cone.point) / base.direction.dot(cone.direction);
  cone.point += along * cone.direction;
  cone.radius += along * std::tan(cone.half_angle);
  return cone;
}

// Whether two descriptions are of one surface: axes, radius and opening, by what they do to points at the cloud's size.
bool is_same(const Cone& a, const Cone& b) {
  constexpr double alike = 1e-2;
  const double sense = a.direction.dot(b.direction) < 0.0 ? -1.0 : 1.0;
  return a.direction.cross(b.direction).norm() < alike && (a.point - b.point).norm() < alike &&
         std::abs(std::abs(a.radius) - std::abs(b.radius)) < alike &&
         std::abs(a.half_angle - sense * b.half_angle) < alike;
}

// Without the points so near the axis that noise turns their derivative round, as at a cone's apex: they say nothing of
// whether the others determine the surface.
Cloud off_the_axis(Cloud cloud, const Cone& cone, double noise) {
  const double near = std::max(5.0 * noise, 1e-6);
  const Eigen::Matrix3Xd from_axis = cloud.points.colwise() - cone.point;
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    if (from_axis.col(i).cross(cone.direction).norm() > near) {
      cloud.points.col(kept) = cloud.points.col(i);
      if (cloud.root_weights.size() > 0) {
        cloud.root_weights(kept) = cloud.root_weights(i);
      }
      ++kept;
    }
  }
  cloud.points.conservativeResize(Eigen::NoChange, kept);
  if (cloud.root_weights.size() > 0) {
    cloud.root_weights.conservativeResize(kept);
  }
  return cloud;
}

// In the direction v of parameters that the points determine least, ∂d/∂v has to differ from zero by more than the
// points' noise makes of it: about one ring of points, or a ring and the apex, an opening is nothing but noise, and a
// slope through it looks determined.
template <typename Model>
bool is_determined_by_noise(const Model& model, const Solution<RoundState, Model::size>& solution, double noise) {
  constexpr double sure = 3.0;
  constexpr int n = Model::size;
  const Eigen::Matrix<double, n, 1> length = solution.triangle.colwise().norm();
  const SmallSvd svd = small_svd(solution.triangle * length.cwiseInverse().asDiagonal());
  const Eigen::Matrix<double, n, 1> weakest =
      length.cwiseInverse().asDiagonal() * Eigen::Matrix<double, n, 1>(svd.right_vectors.col(n - 1));
  const Cloud few = off_the_axis(thinned(model.cloud, start_points), cone_of(solution.state), noise);
  const auto derivatives = [&](const Eigen::Vector3d& shift) {
    Cloud shifted = few;
    shifted.points.colwise() += shift;
    std::vector<double> values;
    Model{shifted}.rows(solution.state, [&](const Eigen::Matrix<double, 1, Model::size + 1>& row) {
      values.push_back(row.template head<Model::size>().dot(weakest));
    });
    return values;
  };
  double by_points = 0.0;
  for (const double value : derivatives(Eigen::Vector3d::Zero())) {
    by_points += value * value;
  }
  double by_noise = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto plus = derivatives(noise * Eigen::Vector3d::Unit(axis));
    const auto minus = derivatives(-noise * Eigen::Vector3d::Unit(axis));
    for (std::size_t i = 0; i < plus.size(); ++i) {
      by_noise += 0.25 * (plus[i] - minus[i]) * (plus[i] - minus[i]);
    }
  }
  return by_points < sure * sure * by_noise;
}

// The deepest of the valleys that the starts lead into, followed to the bottom on all the points.
template <bool Tapered>
struct Deepest {
  Solution<RoundState, AxialModel<Tapered>::size> solution;
  bool is_alone = true;  ///< no other surface holds the points as well, as far as their noise shows
};

template <bool Tapered>
Deepest<Tapered> deepest(const Cloud& cloud, const std::vector<RoundState>& starts) {
  using Model = AxialModel<Tapered>;
  const Cloud few = thinned(cloud, start_points);
  std::vector<Solution<RoundState, Model::size>> found;
  for (const RoundState& start : starts) {
    found.push_back(minimise(Model{few}, start, 60));
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  auto best = minimise(Model{cloud}, found.front().state, 500);
  if (few.size() < cloud.size()) {
    // What is deepest for a few points need not be for all of them.
    for (std::size_t i = 1; i < std::min<std::size_t>(3, found.size()); ++i) {
      const auto other = minimise(Model{cloud}, found[i].state, 500);
      best = other.cost < best.cost ? other : best;
    }
    return {best};
  }
  if (cloud.size() <= Model::size) {
    return {best};  // nothing contradicts any of those that pass through all points: there is no covariance then
  }
  const auto freedom = static_cast<double>(cloud.size() - Model::size);
  const double alike = 9.0 * std::max(best.cost / freedom, cloud.rounding * cloud.rounding);
  const Cone answer = cone_of(best.state);
  for (std::size_t i = 1; i < found.size(); ++i) {
    if (found[i].cost < best.cost + 100.0 * alike && !is_same(cone_of(found[i].state), answer)) {
      const auto other = minimise(Model{cloud}, found[i].state, 500);
      if (other.cost < best.cost + alike && !is_same(cone_of(other.state), answer)) {
        return {other.cost < best.cost ? other : best, false};
      }
    }
  }
  return {best};
}

std::string too_small(std::string_view feature, const Cloud& cloud, double radius, double doubt) {
  return fmt::format(
      "the points do not determine a {}: on so small a patch its radius {:.4g} mm comes out with a standard "
      "uncertainty of {:.2g} mm; probe more of it",
      feature, radius * cloud.scale, doubt * cloud.scale);
}

std::string several(std::string_view feature) {
  return fmt::format(
      "the points do not determine a {}: several different ones hold them equally well; probe more points, at several "
      "heights and around it",
      feature);
}

std::string undetermined(std::string_view feature, const Cloud& cloud, double noise, double radius) {
  return scatter_hides(feature, cloud, noise, radius)
      .value_or(fmt::format(
          "the points do not determine a {}: they lie on one circle or on few straight lines{}, which leave its "
          "axis free; probe at several heights and around it",
          feature, as_noise_shows(cloud, noise)));
}

}  // namespace

Expected<Estimate<Cylinder>> least_squares_cylinder(const Cloud& cloud, const FitOptions& options) {
  const auto [solution, is_alone] = deepest<false>(cloud, start_cylinders(thinned(cloud, start_points), start_count));
  const auto cylinder_of = [base = cone_of(solution.state)](const RoundState& state) {
    const Cone cone = abreast(cone_of(state), base);
    return Cylinder{cone.point, cone.direction, cone.radius};
  };
  auto [estimate, unit] =
      estimate_of(AxialModel<false>{cloud}, solution, static_cast<int>(cloud.size()), options, cylinder_of);
  const double noise = noise_or_rounding(cloud, estimate.noise);
  if (!unit || is_determined_by_noise(AxialModel<false>{cloud}, solution, noise)) {
    return no_solution(undetermined("cylinder", cloud, noise, estimate.feature.radius));
  }
  if (!is_alone) {
    return no_solution(several("cylinder"));
  }
  const double radius = estimate.feature.radius;
  const double doubt = noise * std::sqrt((*unit)(6, 6));
  if (!(doubt < 0.5 * radius)) {
    return no_solution(too_small("cylinder", cloud, radius, doubt));
  }
  return estimate;
}

Expected<Estimate<Cone>> least_squares_cone(const Cloud& cloud, const FitOptions& options) {
  const auto [solution, is_alone] = deepest<true>(cloud, start_cones(thinned(cloud, start_points), start_count));
  const auto feature_of = [base = cone_of(solution.state)](const RoundState& state) {
    return abreast(cone_of(state), base);
  };
  auto [estimate, unit] =
      estimate_of(AxialModel<true>{cloud}, solution, static_cast<int>(cloud.size()), options, feature_of);
  const double noise = noise_or_rounding(cloud, estimate.noise);
  if (!unit || is_determined_by_noise(AxialModel<true>{cloud}, solution, noise)) {
    return no_solution(undetermined("cone", cloud, noise, estimate.feature.radius));
  }
  if (!is_alone) {
    return no_solution(several("cone"));
  }
  open_forwards(estimate);
  const double angle = estimate.feature.half_angle;
  const double angle_doubt = noise * std::sqrt((*unit)(7, 7));
  if (!(angle_doubt < 0.5 * angle)) {
    return no_solution(
        fmt::format("the points do not determine a cone: its half angle {:.3g} rad is not known from zero "
                    "(standard uncertainty {:.2g} rad); is it a cylinder?",
                    angle, angle_doubt));
  }
  const double radius = std::abs(estimate.feature.radius);
  const double doubt = noise * std::sqrt((*unit)(6, 6));
  if (!(doubt < 0.5 * std::max(radius, 1.0))) {
    return no_solution(too_small("cone", cloud, radius, doubt));
  }
  return estimate;
}

}  // namespace artcal::fitting
