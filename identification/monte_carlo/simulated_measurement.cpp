#include "identification/monte_carlo/simulated_measurement.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "acquisition/arm/forward_kinematics.h"
#include "artefacts/simulation/pattern.h"
#include "artefacts/virtual_probing/postures.h"
#include "core/normal_vector.h"
#include "fitting/fit.h"
#include "identification/monte_carlo/turned_joints.h"
#include "identification/uncertainty/working_volume.h"

namespace artcal {
namespace {

constexpr int orientations = 5;
constexpr int points_each = 5;
constexpr int max_draws = 50;  // of one length, ball or articulation before it is given up
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

std::optional<MeasuringPlan::Ball> draw_ball(const Arm& arm, const MeasuringRequest& request, RandomStream& random) {
  MeasuringPlan::Ball ball;
  ball.centre_in_base = tip_at(arm, request.probe, random_posture(arm, random));
  const Eigen::Matrix3d turn = random.rotation();
  const double radius = 0.5 * request.diameter + arm.probes[request.probe].radius;
  for (const Eigen::Vector3d& direction : iso_directions()) {
    auto q = inverse_kinematics(arm, request.probe, ball.centre_in_base + radius * (turn * direction), random);
    if (!q) {
      return std::nullopt;
    }
    ball.q.push_back(std::move(*q));
  }
  return ball;
}

// The pole and four points at 60 degrees from it, each near the posture that the orientation begins with.
std::optional<MeasuringPlan::Articulation> draw_articulation(const Arm& arm, const MeasuringRequest& request,
                                                             RandomStream& random) {
  MeasuringPlan::Articulation articulation;
  const Eigen::Vector3d centre = tip_at(arm, request.probe, random_posture(arm, random));
  const double radius = 0.5 * request.diameter + arm.probes[request.probe].radius;
  for (int orientation = 0; orientation < orientations; ++orientation) {
    const auto start = inverse_kinematics(arm, request.probe, centre, random);
    const Eigen::Matrix3d turn = random.rotation();
    for (int i = 0; start && i < points_each; ++i) {
      const double round = 0.5 * std::numbers::pi * i;
      const double from_pole = i == 0 ? 0.0 : std::numbers::pi / 3.0;
      const Eigen::Vector3d direction(std::sin(from_pole) * std::cos(round), std::sin(from_pole) * std::sin(round),
                                      std::cos(from_pole));
      auto q = reach_with_joints(arm, request.probe, centre + radius * (turn * direction), *start);
      if (!q) {
        return std::nullopt;
      }
      articulation.q.push_back(std::move(*q));
    }
  }
  return articulation.q.size() == orientations * points_each ? std::optional(articulation) : std::nullopt;
}

template <typename Draw>
auto drawn_at_last(Draw draw) {
  auto found = draw();
  for (int attempt = 1; !found && attempt < max_draws; ++attempt) {
    found = draw();
  }
  return found;
}

Expected<void> add_asked_points(const Arm& arm, const MeasuringRequest& request, MeasuringPlan& plan) {
  RandomStream random(request.seed, "measuring: asked");
  for (const Eigen::Vector3d& place : request.points_in_base) {
    auto q = inverse_kinematics(arm, request.probe, place, random);
    if (!q) {
      return bad_input(fmt::format("the arm does not reach the point ({:g}, {:g}, {:g}) mm of its base frame",
                                   place.x(), place.y(), place.z()));
    }
    if (!plan.points.empty()) {
      plan.lengths.push_back(
          {fmt::format("length {} to {}", plan.points.size(), plan.points.size() + 1), {plan.points.back().q, *q}});
    }
    plan.points.push_back({fmt::format("point {}", plan.points.size() + 1), std::move(*q)});
  }
  return {};
}

void add_drawn_lengths(const Arm& arm, const MeasuringRequest& request, MeasuringPlan& plan) {
  std::uint64_t index = 0;
  for (const double share : surveyed_lengths) {
    const double length = share * reach(arm);
    RandomStream random(request.seed, "measuring: lengths", index++);
    for (int i = 0; i < request.lengths; ++i) {
      const auto drawn = drawn_at_last([&]() -> std::optional<MeasuringPlan::Length> {
        const Eigen::VectorXd first = random_posture(arm, random);
        auto second = inverse_kinematics(arm, request.probe,
                                         tip_at(arm, request.probe, first) + length * random.direction(), random);
        return second ? std::optional(MeasuringPlan::Length{"", {first, std::move(*second)}}) : std::nullopt;
      });
      if (drawn) {
        plan.lengths.push_back(*drawn);
        plan.lengths.back().name = fmt::format("length of {:.0f} mm, {}", length, i + 1);
      }
    }
  }
}

double around(const Eigen::Matrix3Xd& centres) {
  FitOptions options;
  options.criterion = Criterion::MinimumCircumscribed;
  const auto sphere = fit<Sphere>(centres, options);
  return sphere ? 2.0 * sphere->feature.radius : no_number;
}

}  // namespace

Expected<MeasuringPlan> plan_measuring(const Arm& arm, const MeasuringRequest& request) {
  MeasuringPlan plan;
  plan.probe = request.probe;
  if (auto added = add_asked_points(arm, request, plan); !added) {
    return tl::unexpected(added.error());
  }
  RandomStream places(request.seed, "measuring: points");
  for (int i = 0; request.points_in_base.empty() && i < request.points; ++i) {
    plan.points.push_back({fmt::format("place {}", i + 1), random_posture(arm, places)});
  }
  add_drawn_lengths(arm, request, plan);
  RandomStream balls(request.seed, "measuring: balls");
  RandomStream orientations_random(request.seed, "measuring: orientations");
  for (int i = 0; i < request.balls; ++i) {
    if (auto ball = drawn_at_last([&] { return draw_ball(arm, request, balls); })) {
      ball->name = fmt::format("ball {}", i + 1);
      plan.balls.push_back(std::move(*ball));
    }
    if (auto drawn = drawn_at_last([&] { return draw_articulation(arm, request, orientations_random); })) {
      drawn->name = fmt::format("ball {}", i + 1);
      plan.articulations.push_back(std::move(*drawn));
    }
  }
  return plan;
}

Measuring::Measuring(MeasuringPlan plan, const UncertainArm& arm, double encoder, double probing)
    : plan_(std::move(plan)), encoder_(encoder), probing_(probing) {
  const UncertainArm quiet = arm.without_noise();
  const auto keep = [&](const Eigen::VectorXd& q) {
    Posture& posture = postures_.emplace_back();
    posture.angles.assign(q.begin(), q.end());
    posture.sines.resize(2 * posture.angles.size());
    joint_sines(posture.angles, posture.sines);
    return arm.tip(q);
  };
  const auto add = [&](Measurand::Kind kind, std::string name, double value, std::optional<double> u) {
    const bool is_error = kind == Measurand::Kind::EUni || kind == Measurand::Kind::PSize;
    quantities_.push_back({kind, std::move(name), "mm", is_error ? 0.0 : value, u});
    true_values_.push_back(is_error ? value : 0.0);
  };
  for (const auto& point : plan_.points) {
    const UncertainTip tip = keep(point.q);
    const Eigen::Matrix3d covariance = quiet.of_point(tip);
    for (int i = 0; i < 3; ++i) {
      add(Measurand::Kind::Coordinate, point.name + " " + "xyz"[i], tip.in_base[i], std::sqrt(covariance(i, i)));
    }
  }
  for (const auto& length : plan_.lengths) {
    const UncertainTip first = keep(length.q[0]);
    const UncertainTip second = keep(length.q[1]);
    const double apart = (second.in_base - first.in_base).norm();
    add(Measurand::Kind::Length, length.name, apart, quiet.of_length(first, second));
    add(Measurand::Kind::EUni, length.name, apart, arm.of_length(first, second));
  }
  for (const auto& ball : plan_.balls) {
    std::vector<UncertainTip> tips;
    for (const auto& q : ball.q) {
      tips.push_back(keep(q));
    }
    const double touched = (tips.front().in_base - ball.centre_in_base).norm();
    add(Measurand::Kind::PSize, ball.name, 2.0 * (touched - arm.arm().probes[plan_.probe].radius),
        arm.of_diameter(tips, ball.centre_in_base));
  }
  for (const auto& articulation : plan_.articulations) {
    for (const auto& q : articulation.q) {
      keep(q);
    }
    add(Measurand::Kind::LDia, articulation.name, 0.0, std::nullopt);
  }
}

void Measuring::measure(const Arm& arm, RandomStream& random, double* values) const {
  double* const first_value = values;
  const ForwardKinematics kinematics(arm, {}, plan_.probe);
  std::size_t next = 0;
  const auto tip_of = [&](const Posture& posture) { return kinematics.tip_in_base({posture.sines, posture.angles}); };
  const auto exact = [&] { return tip_of(postures_[next++]); };
  Posture noisy;
  const auto read = [&] {
    noisy = postures_[next++];
    if (encoder_ > 0.0) {
      turn_joints(noisy.angles, noisy.sines, encoder_, random);
    }
    return Eigen::Vector3d(tip_of(noisy) + probing_ * normal_vector(random));
  };
  for (std::size_t i = 0; i < plan_.points.size(); ++i, values += 3) {
    Eigen::Vector3d::Map(values) = exact();
  }
  for (std::size_t i = 0; i < plan_.lengths.size(); ++i) {
    const Eigen::Vector3d first = exact();
    *values++ = (exact() - first).norm();
    next -= 2;
    const Eigen::Vector3d first_read = read();
    *values++ = (read() - first_read).norm();
  }
  for (const auto& ball : plan_.balls) {
    Eigen::Matrix3Xd tips(3, static_cast<Eigen::Index>(ball.q.size()));
    for (auto tip : tips.colwise()) {
      tip = read();
    }
    const auto sphere = fit<Sphere>(tips);
    *values++ = sphere ? 2.0 * (sphere->feature.radius - kinematics.tip_radius()) : no_number;
  }
  for (std::size_t i = 0; i < plan_.articulations.size(); ++i) {
    Eigen::Matrix3Xd centres(3, orientations);
    for (auto centre : centres.colwise()) {
      Eigen::Matrix3Xd tips(3, points_each);
      for (auto tip : tips.colwise()) {
        tip = read();
      }
      const auto sphere = fit<Sphere>(tips);
      centre = sphere ? sphere->feature.centre : Eigen::Vector3d::Constant(no_number);
    }
    *values++ = centres.allFinite() ? around(centres) : no_number;
  }
  for (std::size_t i = 0; i < true_values_.size(); ++i) {
    first_value[i] -= true_values_[i];
  }
}

}  // namespace artcal
