// Where to put an artefact next: plans against chance, and against what their recordings then give.
#include "identification/planning/planning.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/simulation/possible_session.h"
#include "artefacts/simulation/posture.h"
#include "artefacts/virtual_probing/postures.h"
#include "identification/planning/ball_patterns.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/recordings.h"
#include "tests/support/simulated_session.h"

namespace artcal {
namespace {

constexpr double arcsecond = std::numbers::pi / 180.0 / 3600.0;

Artefact ball_bar(double u = 3e-4) {
  Artefact bar;
  bar.name = "bar";
  for (const char* name : {"A", "B"}) {
    bar.features.push_back(testing::feature_of(name, FeatureKind::Sphere));
    bar.features.back().radius = 12.7;
  }
  bar.distances = {{0, 1, 500.0, u}};
  return bar;
}

struct Possible {
  Simulation simulation;
  Constraints constraints;
};

Possible possible(std::uint64_t seed, int placements, int readings, const Artefact& bar = ball_bar()) {
  Arm arm = test::gao_arm();
  arm.probes.front().radius = 3.0;
  const auto simulation = simulate(possible_session(arm, bar, {placements, readings, seed}));
  if (!simulation) throw std::runtime_error(simulation.error().text());
  auto constraints = build_constraints(simulation->recording, {bar});
  if (!constraints) throw std::runtime_error(constraints.error().text());
  return {*simulation, std::move(*constraints)};
}

PlanningOptions options_of(int placements, int readings, std::uint64_t seed) {
  PlanningOptions options;
  options.placements = placements;
  options.readings = readings;
  options.noise.encoder = 2.0 * arcsecond;
  options.noise.probing = 0.003;
  options.seed = seed;
  return options;
}

Planning planned(const Possible& pool, const PlanningOptions& options) {
  auto plan = plan_session(pool.simulation, pool.constraints, nullptr, nullptr, options);
  if (!plan) throw std::runtime_error(plan.error().text());
  return std::move(*plan);
}

// Five planned placements against ten by chance (medians of twenty), both by lengths that nothing was chosen by. What
// the readings of the length itself add is the same for both, and most of the worst.
TEST(PlanSession, HalfOfAPlanIsWorthAllOfChance) {
  double mean = 0.0;
  double mean_by_chance = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    PlanningOptions options = options_of(5, 8, seed);
    options.random_placements = 10;
    const Planning half = planned(possible(seed, 60, 16), options);
    EXPECT_LT(half.planned.u_of_arm.mean, 1.05 * half.random_of_arm.mean) << "seed " << seed;
    EXPECT_LT(half.planned.u_of_arm.worst, 1.06 * half.random_of_arm.worst) << "seed " << seed;
    EXPECT_LT(half.planned.u.worst, 1.08 * half.random.worst) << "seed " << seed;
    mean += half.planned.u.mean / 20.0;
    mean_by_chance += half.random.mean / 20.0;
  }
  EXPECT_LT(mean, mean_by_chance);
}

TEST(PlanSession, GoalsAreLoweredAndTheSameEveryTime) {
  const Possible pool = possible(3, 40, 12);
  PlanningOptions options = options_of(4, 8, 3);
  const Planning by_worst = planned(pool, options);
  const Planning again = planned(pool, options);
  ASSERT_EQ(by_worst.chosen.size(), again.chosen.size());
  for (std::size_t i = 0; i < by_worst.chosen.size(); ++i) {
    EXPECT_EQ(by_worst.chosen[i].candidate, again.chosen[i].candidate);
    EXPECT_EQ(by_worst.chosen[i].readings, again.chosen[i].readings);
  }
  options.goal = Goal::Mean;
  const Planning by_mean = planned(pool, options);
  EXPECT_LT(by_mean.planned.u.mean, 1.001 * by_worst.planned.u.mean);
  EXPECT_LT(by_worst.planned.u.worst, by_worst.random.worst);
  for (const ChosenPlacement& chosen : by_mean.chosen) {
    EXPECT_EQ(chosen.readings.size(), 16u);
  }
}

// The recording of a plan, read with encoders that scatter as stated, gives an arm as good as was foretold.
TEST(PlanSession, ForetellsWhatItsRecordingGives) {
  double squares = 0.0;
  constexpr int sessions = 12;
  const Possible pool = possible(9, 30, 12);
  PlanningOptions options = options_of(5, 8, 9);
  options.noise.probing = 1e-4;  // moves the tip, which here does not move
  const Planning plan = planned(pool, options);
  for (std::uint64_t session = 0; session < sessions; ++session) {
    RandomStream random(session, "noise");
    Recording recording = pool.simulation.recording;
    std::vector<int> taken;
    for (const auto& chosen : plan.chosen) taken.insert(taken.end(), chosen.readings.begin(), chosen.readings.end());
    recording.readings.clear();
    recording.joints.resize(recording.joints.rows(), static_cast<Eigen::Index>(taken.size()));
    for (std::size_t i = 0; i < taken.size(); ++i) {
      recording.readings.push_back(pool.simulation.recording.readings[static_cast<std::size_t>(taken[i])]);
      for (Eigen::Index joint = 0; joint < recording.joints.rows(); ++joint) {
        recording.joints(joint, static_cast<Eigen::Index>(i)) =
            pool.simulation.recording.joints(joint, taken[i]) + 2.0 * arcsecond * random.normal();
      }
    }
    recording.noise = options.noise;
    IdentifyOptions identify_options;
    identify_options.leave_out = false;
    identify_options.noise = options.noise;
    const auto result = test::identified(test::bind(recording, {ball_bar()}), identify_options);
    squares += std::pow(testing::length_rms(pool.simulation.arm.arm, result.arm), 2) / sessions;
  }
  // Twelve sessions of some 24 parameters: the ratio scatters by about 6 %.
  EXPECT_NEAR(std::sqrt(squares) / plan.planned.u_of_arm.mean, 1.0, 0.2);
}

TEST(PlanSession, WhatIsMeasuredCounts) {
  const Possible pool = possible(5, 20, 12);
  const Possible before = possible(6, 6, 10);
  const PlanningOptions options = options_of(2, 8, 5);
  const auto plan =
      plan_session(pool.simulation, pool.constraints, &before.simulation.recording, &before.constraints, options);
  ASSERT_TRUE(plan) << plan.error().text();
  ASSERT_TRUE(plan->measured);
  const Planning alone = planned(pool, options);
  EXPECT_LT(plan->planned.u.mean, plan->measured->u.mean);
  EXPECT_LT(plan->planned.u.mean, alone.planned.u.mean);
  EXPECT_GT(plan->planned.u.mean, plan->all.u.mean);
}

// The dilution of a ball's centre by a numerical derivative that shares nothing with the code: how far the best sphere
// moves (Gauss, Newton from the true one) when one touch of the unit ball lies 1e-5 farther out, over all touches.
double dilution_by_differences(const std::vector<Eigen::Vector3d>& directions) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t moved = 0; moved < directions.size(); ++moved) {
    Eigen::Vector4d ball(0.0, 0.0, 0.0, 1.0);
    for (int iteration = 0; iteration < 5; ++iteration) {
      Eigen::MatrixXd slopes(directions.size(), 4);
      Eigen::VectorXd off(directions.size());
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const Eigen::Vector3d from_centre = (i == moved ? 1.0 + 1e-5 : 1.0) * directions[i] - ball.head<3>();
        off(static_cast<Eigen::Index>(i)) = from_centre.norm() - ball(3);
        slopes.row(static_cast<Eigen::Index>(i)) << from_centre.normalized().transpose(), 1.0;
      }
      ball += slopes.colPivHouseholderQr().solve(off);
    }
    covariance += ball.head<3>() * ball.head<3>().transpose() / 1e-10;
  }
  return std::sqrt(covariance.jacobiSvd().singularValues()(0));
}

TEST(BallPatterns, TouchesOnAPatchAreSpread) {
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < 8; ++i) {
    directions.emplace_back(Eigen::Vector3d(0.2 * std::cos(0.8 * i), 0.2 * std::sin(0.8 * i), 1.0).normalized());
  }
  for (int i = 0; i < 8; ++i) {
    directions.emplace_back(Eigen::Vector3d(std::cos(0.7 * i), std::sin(0.7 * i), 0.1 * i - 0.3).normalized());
  }
  const auto some = [&](const std::vector<int>& chosen) {
    std::vector<Eigen::Vector3d> all;
    for (const int i : chosen) all.push_back(directions[static_cast<std::size_t>(i)]);
    return all;
  };
  const std::vector<int> patch{0, 2, 4, 5, 7};
  ASSERT_GT(dilution_by_differences(some(patch)), 20.0);
  const std::vector<int> spread = spread_touches(directions, patch);
  EXPECT_EQ(spread.size(), 5u);
  EXPECT_LT(dilution_by_differences(some(spread)), max_planned_dilution);
  const std::vector<int> good{0, 8, 10, 12, 14};
  EXPECT_EQ(spread_touches(directions, good), good);
  const std::vector<int> few{0, 1, 2};
  EXPECT_EQ(spread_touches(directions, few), few);
}

// Five touches a ball, in forty placements: no ball on a patch.
TEST(PlanSession, ProposesNoTouchesOnAPatch) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Possible pool = possible(seed, 6, 12);
    for (const ChosenPlacement& chosen : planned(pool, options_of(2, 5, seed)).chosen) {
      ASSERT_EQ(chosen.balls.size(), 2u);
      for (const PlannedBall& ball : chosen.balls) {
        EXPECT_EQ(ball.touches, 5);
        EXPECT_LT(ball.dilution, max_planned_dilution) << "seed " << seed;
      }
    }
  }
}

// A bar of two seats: unlike balls, whose radius is a length too, they bring no scale but the certificate's.
Artefact seat_bar(double u) {
  Artefact bar = ball_bar(u);
  for (CertifiedFeature& feature : bar.features) feature = testing::feature_of(feature.name, FeatureKind::Point);
  return bar;
}

/// The u of lengths by generalised least squares over all readings of a possible session: kinematics written a second
/// time, numerical derivatives, dense normal equations, and the certificate's error as a fully correlated block of the
/// covariance of the distances, not as an unknown.
class DenseDesign {
 public:
  DenseDesign(const Possible& session, const std::vector<Parameter>& free, const Noise& noise, double u)
      : arm_(session.simulation.arm.arm), free_(free), noise_(noise) {
    const Recording& recording = session.simulation.recording;
    for (const Parameter& parameter : free) unit_.push_back(parameter.is_angle() ? 1.0 / reach(arm_) : 1.0);
    const auto arm_size = static_cast<Eigen::Index>(free.size());
    const auto features = static_cast<Eigen::Index>(session.constraints.features.size());
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(arm_size + 3 * features, arm_size + 3 * features);
    normal.diagonal().head(arm_size).setConstant(0.01);  // every parameter is known to 10 mm beforehand
    std::vector<Eigen::Vector3d> centres;
    for (Eigen::Index f = 0; f < features; ++f) {
      Eigen::Vector3d centre = Eigen::Vector3d::Zero();
      const auto& readings = session.constraints.features[static_cast<std::size_t>(f)].readings;
      for (const int reading : readings) {
        const Eigen::VectorXd q = recording.joints.col(reading);
        centre += tip(arm_, q) / static_cast<double>(readings.size());
        Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3, normal.cols());
        rows.leftCols(arm_size) = by_arm(q);
        rows.middleCols<3>(arm_size + 3 * f) = -Eigen::Matrix3d::Identity();
        normal += rows.transpose() * noise_of(q).inverse() * rows;
      }
      centres.push_back(centre);
    }
    const auto& distances = session.constraints.distances;
    const auto count = static_cast<Eigen::Index>(distances.size());
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count, normal.cols());
    for (Eigen::Index d = 0; d < count; ++d) {
      const DistanceConstraint& distance = distances[static_cast<std::size_t>(d)];
      const Eigen::Vector3d along = (centres[distance.second] - centres[distance.first]).normalized();
      rows.block<1, 3>(d, arm_size + 3 * distance.second) = along.transpose();
      rows.block<1, 3>(d, arm_size + 3 * distance.first) = -along.transpose();
    }
    const Eigen::MatrixXd common =
        u * u * (Eigen::MatrixXd::Ones(count, count) + 1e-6 * Eigen::MatrixXd::Identity(count, count));
    normal += rows.transpose() * common.inverse() * rows;
    covariance_ = normal.inverse().topLeftCorner(arm_size, arm_size);
  }

  /// Root mean square over lengths between postures that nothing else was told by, mm.
  [[nodiscard]] double u_of_lengths(const VirtualArm& arm) const {
    RandomStream random(77, "lengths");
    double squares = 0.0;
    constexpr int count = 1000;
    for (int i = 0; i < count; ++i) {
      const Eigen::VectorXd first = random_readings(arm, random), second = random_readings(arm, random);
      const Eigen::Vector3d along = (tip(arm_, second) - tip(arm_, first)).normalized();
      const Eigen::RowVectorXd slope = along.transpose() * (by_arm(second) - by_arm(first));
      squares += slope * covariance_ * slope.transpose();
    }
    return std::sqrt(squares / count);
  }

 private:
  static Eigen::Vector3d tip(const Arm& arm, const Eigen::VectorXd& q) {
    return testing::tip_in_base(testing::ArmNumbers<double>(arm), std::vector<double>(q.begin(), q.end()), 0);
  }

  [[nodiscard]] Eigen::MatrixXd by_arm(const Eigen::VectorXd& q) const {
    Eigen::MatrixXd slopes(3, static_cast<Eigen::Index>(free_.size()));
    for (std::size_t p = 0; p < free_.size(); ++p) {
      testing::ArmNumbers<double> more(arm_), less(arm_);
      const double step = 1e-2 * unit_[p];
      more.at(free_[p]) += step;
      less.at(free_[p]) -= step;
      const std::vector<double> angles(q.begin(), q.end());
      slopes.col(static_cast<Eigen::Index>(p)) =
          (testing::tip_in_base(more, angles, 0) - testing::tip_in_base(less, angles, 0)) / 2e-2;
    }
    return slopes;
  }

  [[nodiscard]] Eigen::Matrix3d noise_of(const Eigen::VectorXd& q) const {
    Eigen::Matrix3d covariance = std::pow(noise_.probing.value(), 2) * Eigen::Matrix3d::Identity();
    for (Eigen::Index joint = 0; joint < q.size(); ++joint) {
      const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(q.size(), joint);
      const Eigen::Vector3d slope = (tip(arm_, q + step) - tip(arm_, q - step)) / 2e-5;
      covariance += std::pow(noise_.encoder.value(), 2) * slope * slope.transpose();
    }
    return covariance;
  }

  Arm arm_;
  std::vector<Parameter> free_;
  Noise noise_;
  std::vector<double> unit_;
  Eigen::MatrixXd covariance_;
};

// A bar certified to 50 µm in 500 mm makes every length of the arm wrong by the same 100 ppm, however often it is set
// up: it is one certificate. Both means are over a thousand lengths of their own or more: they differ by 2 % by chance.
TEST(PlanSession, OneCertificateIsNoBetterInManyPlacements) {
  constexpr double u = 0.05;
  std::vector<double> all;
  for (const int placements : {4, 16}) {
    const Possible session = possible(4, placements, 6, seat_bar(u));
    const Planning plan = planned(session, options_of(placements, 6, 4));
    const DenseDesign dense(session, plan.free, options_of(placements, 6, 4).noise, u);
    all.push_back(plan.planned.u_of_arm.mean);
    EXPECT_NEAR(all.back() / dense.u_of_lengths(session.simulation.arm), 1.0, 0.04) << placements << " placements";
  }
  // The share of the certificate alone, 100 ppm of the lengths, stays; four times as many placements with an error each
  // would halve it.
  EXPECT_GT(all.back(), 0.9 * all.front());
}

// Nor where the bar was measured before: its error is the same then.
TEST(PlanSession, ACertificateIsTheSameInWhatWasMeasured) {
  const Possible session = possible(4, 8, 8, seat_bar(0.05));
  const Possible before = possible(6, 6, 10, seat_bar(0.05));
  const auto plan = plan_session(session.simulation, session.constraints, &before.simulation.recording,
                                 &before.constraints, options_of(2, 8, 5));
  ASSERT_TRUE(plan) << plan.error().text();
  const VirtualArm& arm = session.simulation.arm;
  RandomStream random(78, "lengths");
  double squares = 0.0;
  for (int i = 0; i < 2000; ++i) {
    squares += (tip_at(arm.arm, 0, random_readings(arm, random)) - tip_at(arm.arm, 0, random_readings(arm, random)))
                   .squaredNorm() /
               2000.0;
  }
  EXPECT_GT(plan->planned.u_of_arm.mean, 0.96e-4 * std::sqrt(squares));  // 100 ppm of each length
}

TEST(PlanSession, RefusesWhatCannotBePlanned) {
  const Possible pool = possible(5, 3, 6);
  const auto refusal = [&](const PlanningOptions& options) {
    const auto plan = plan_session(pool.simulation, pool.constraints, nullptr, nullptr, options);
    return plan ? std::string("accepted") : plan.error().text();
  };
  EXPECT_THAT(refusal(options_of(4, 4, 1)), ::testing::HasSubstr("4 placements are to be chosen, but only 3"));
  PlanningOptions silent = options_of(2, 4, 1);
  silent.noise = {};
  EXPECT_THAT(refusal(silent), ::testing::HasSubstr("noise of the readings is not stated"));
}

TEST(Observability, OfKnownValues) {
  const Observability o = observability_of(Eigen::Vector3d(4.0, 2.0, 1.0), 16);
  EXPECT_DOUBLE_EQ(o.o1, 0.5);  // cube root of 8 over four
  EXPECT_DOUBLE_EQ(o.o2, 0.25);
  EXPECT_DOUBLE_EQ(o.o3, 1.0);
  EXPECT_DOUBLE_EQ(o.o4, 0.25);
  EXPECT_DOUBLE_EQ(o.o5, 1.0 / 1.75);
}

}  // namespace
}  // namespace artcal
