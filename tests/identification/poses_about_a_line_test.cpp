// Artefacts whose points lie on a line, or nearly on one. Truth: planted arms, poses and turns, read through an
// independent forward kinematics; and that no least-squares fit can be worse than what was planted.
#include "core/normal_vector.h"
#include "identification/initial/pose_start.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/virtual_probing/postures.h"
#include "core/random.h"
#include "identification/identify.h"
#include "identification/least_squares/residual.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/recordings.h"

namespace artcal {
namespace {

Arm off_by(Arm arm, double share, std::uint64_t seed) {
  RandomStream random(seed, "off by");
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    Joint& joint = arm.joints[i];
    const bool last = i + 1 == arm.joints.size();
    joint.a += last ? 0.0 : share * 0.3 * random.normal();
    joint.d += last || i == 0 ? 0.0 : share * 0.3 * random.normal();
    joint.theta += i == 0 ? 0.0 : share * 1.7e-3 * random.normal();
    joint.alpha += share * 1.7e-3 * random.normal();
  }
  arm.probes.front().tip_in_last.z() += share * 0.3 * random.normal();
  return arm;
}

struct Session {
  Recording recording;
  Artefact bar;
  double planted_squares = 0.0;  ///< of the planted arm and poses, in the noise's units
};

// A bar of points in several placements, each point read `repeats` times from anywhere with `noise` in each coordinate.
Session read_bar(const Arm& truth, const std::vector<Eigen::Vector3d>& points, int placements, int repeats,
                 double noise, std::uint64_t seed) {
  RandomStream random(seed, "bar");
  Session session;
  Recording& recording = session.recording;
  recording.name = "bar";
  recording.files = {"planted"};
  recording.artefacts.index_of("bar");
  session.bar.name = "bar";
  session.bar.frame = CoordinateFrame::Artefact;
  for (std::size_t i = 0; i < points.size(); ++i) {
    CertifiedFeature feature;
    feature.name = std::to_string(i);
    feature.kind = FeatureKind::Point;
    feature.at = points[i];
    session.bar.features.push_back(feature);
  }
  const testing::ArmNumbers<double> numbers(truth);
  std::vector<double> joints;
  for (int p = 0; p < placements; ++p) {
    const Eigen::Vector3d place = 700.0 * random.direction();
    const Eigen::Matrix3d rotation = random.rotation();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d target = place + rotation * (points[i] - points[points.size() / 2]);
      for (int r = 0; r < repeats; ++r) {
        const Eigen::Vector3d off = noise * normal_vector(random);
        const auto q = inverse_kinematics(truth, 0, target + off, random, 50);
        if (!q) continue;
        const auto tip = testing::tip_in_base(numbers, std::vector<double>(q->begin(), q->end()), 0);
        session.planted_squares += noise > 0.0 ? (tip - target).squaredNorm() / (noise * noise) : 0.0;
        Reading reading{};
        reading.placement = recording.placements.index_of(std::to_string(p));
        reading.feature = recording.features.index_of(session.bar.features[i].name);
        reading.orientation = recording.orientations.index_of("");
        reading.repeat = recording.repeats.index_of("");
        reading.temperature = std::numeric_limits<double>::quiet_NaN();
        reading.line = static_cast<int>(recording.readings.size()) + 1;
        recording.readings.push_back(reading);
        joints.insert(joints.end(), q->begin(), q->end());
      }
    }
  }
  recording.joints = Eigen::MatrixXd::Map(joints.data(), 6, static_cast<Eigen::Index>(recording.readings.size()));
  return session;
}

Identification identified_from(const Session& session, const Arm& nominal, double noise) {
  Recording recording = session.recording;
  recording.arm = nominal;
  IdentifyOptions options;
  options.noise.reading = noise;
  options.leave_out = false;
  return test::identified(test::bind(std::move(recording), {session.bar}), options);
}

std::vector<Eigen::Vector3d> bar_of_four(double straightness) {
  return {{0.0, 0.0, 0.0},
          {250.0, straightness, 0.0},
          {600.0, 0.0, 0.6 * straightness},
          {900.0, -0.2 * straightness, 0.1 * straightness}};
}

// Two points have nothing but their distance; four on a line add that they are on one. Turned out of the axes, and far
// from the artefact's origin, for good measure.
TEST(PosesAboutALine, PointsOnALineIdentifyTheArm) {
  const Arm truth = off_by(test::gao_arm(), 1.0, 3);
  std::vector<Eigen::Vector3d> oblique = bar_of_four(0.0);
  const Eigen::Matrix3d turn = rotation_of({0.3, -0.7, 1.1});
  for (auto& point : oblique) point = turn * point + Eigen::Vector3d(100.0, -2000.0, 30.0);
  const std::vector<std::vector<Eigen::Vector3d>> bars{bar_of_four(0.0), oblique, {{0.0, 0.0, 0.0}, {0.0, 500.0, 0.0}}};
  for (std::size_t b = 0; b < bars.size(); ++b) {
    SCOPED_TRACE(b);
    const Session session = read_bar(truth, bars[b], 8, 6, 0.0, 5);
    const auto constraints = build_constraints(session.recording, {session.bar});
    ASSERT_TRUE(constraints);
    for (const auto& group : constraints->groups) {
      EXPECT_EQ(group.size, 5);
      EXPECT_EQ(group.turn, PoseTurn::Unseen);
    }
    const Identification result = identified_from(session, test::gao_arm(), 0.01);
    EXPECT_EQ(result.coupling.rank, 21);
    for (const auto& parameter : result.parameters) {
      EXPECT_NEAR(parameter.identified, value(truth, parameter.parameter), parameter.parameter.is_angle() ? 1e-9 : 1e-6)
          << parameter.parameter.name;
    }
    EXPECT_LT(result.after.overall.rms, 1e-7);
  }
}

class NearlyOnALine : public ::testing::TestWithParam<double> {};

// The global minimum cannot be worse than the planted arm, poses and turns; a wrong turn is worse by
// (2·straightness/noise)² a reading. And it is the same minimum from every start.
TEST_P(NearlyOnALine, TheLowestMinimumIsFoundFromEveryStart) {
  const double straightness = GetParam();
  constexpr double noise = 0.01;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Arm truth = off_by(test::gao_arm(), 1.0, 10 + seed);
    const Session session = read_bar(truth, bar_of_four(straightness), 6, 5, noise, seed);
    double first = 0.0;
    for (const std::uint64_t start : {21, 22, 23, 24}) {
      SCOPED_TRACE(::testing::Message() << "session " << seed << ", start " << start);
      const Identification result = identified_from(session, off_by(truth, 1.0, start), noise);
      EXPECT_LE(result.chi_squared, session.planted_squares);
      first = start == 21 ? result.chi_squared : first;
      EXPECT_NEAR(result.chi_squared, first, 1e-4 * first);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Straightness, NearlyOnALine, ::testing::Values(0.03, 0.1, 0.3, 3.0));

// Where the points are straighter than the readings are good, the turn means nothing and must not keep the arm from
// being found.
TEST(PosesAboutALine, StraighterThanTheNoiseIsFoundToo) {
  for (const double straightness : {0.0005, 0.01}) {
    SCOPED_TRACE(straightness);
    const Arm truth = off_by(test::gao_arm(), 1.0, 31);
    const Session session = read_bar(truth, bar_of_four(straightness), 6, 5, 0.02, 8);
    const Identification result = identified_from(session, test::gao_arm(), 0.02);
    EXPECT_LE(result.chi_squared, session.planted_squares);
  }
}

TEST(PosesAboutALine, ResidualsHaveTheirDerivatives) {
  RandomStream random(4, "turns");
  for (const PoseTurn turn : {PoseTurn::Unseen, PoseTurn::Scaled}) {
    FeatureConstraint constraint;
    constraint.location = Location::Posed;
    constraint.readings = {0};
    constraint.known = {100.0 * random.direction()};
    constraint.expansion = 1.25;
    constraint.first_error = 0;
    GroupReference reference;
    reference.rotation = random.rotation();
    reference.turn = turn;
    reference.line.artefact_from_line = random.rotation();
    reference.line.middle = 20.0 * random.direction();
    const int size = turn == PoseTurn::Unseen ? 5 : 7;
    Eigen::VectorXd at(size + 6);
    for (double& v : at) v = random.uniform(-1.0, 1.0);
    at.segment<3>(2) *= 200.0;
    at.tail<3>() *= 300.0;
    const auto value_at = [&](const Eigen::VectorXd& x) {
      return FeatureResidual(constraint, reference, x.data(), x.data() + size).at(0, x.tail<3>(), 0.0, false).value;
    };
    const FeatureResidual residual(constraint, reference, at.data(), at.data() + size);
    ASSERT_EQ(residual.columns(), size);
    const Residual r = residual.at(0, at.tail<3>(), 0.0, true);
    Eigen::MatrixXd slope(3, size + 6);
    slope << r.by_unknowns.leftCols(size), r.by_errors, r.by_tip;
    for (int i = 0; i < at.size(); ++i) {
      const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(at.size(), i);
      const Eigen::Vector3d difference = (value_at(at + step) - value_at(at - step)) / 2e-5;
      EXPECT_LT((difference - slope.col(i)).norm(), 1e-6 * (1.0 + difference.norm())) << i;
    }
  }
}

}  // namespace
}  // namespace artcal
