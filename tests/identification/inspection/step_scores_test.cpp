// Steps planted into the readings of one joint, found by one linearisation.
#include "identification/inspection/hypotheses/step_scores.h"

#include <gtest/gtest.h>

#include "core/units.h"
#include "identification/initial/coarse_fit.h"
#include "tests/support/recordings.h"
#include "tests/support/simulated_session.h"

namespace artcal {
namespace {

constexpr double tip_radius = 3.0;
constexpr double ball_radius = 12.7;

Artefact two_balls() {
  Artefact bar;
  bar.name = "bar";
  for (const char* name : {"A", "B"}) {
    bar.features.push_back(testing::feature_of(name, FeatureKind::Sphere));
    bar.features.back().radius = ball_radius;
  }
  bar.distances.push_back({0, 1, 500.0, 4e-4});
  return bar;
}

// Of an arm whose lengths are off by `mm` and whose angles by `mm` in 170 mm.
Recording session(double mm) {
  Arm nominal = test::gao_arm();
  nominal.probes[0].radius = tip_radius;
  RandomStream errors(7, "errors");
  testing::Session session(nominal, testing::arm_with_errors(nominal, errors, mm, mm / 170.0), 7);
  for (int p = 0; p < 8; ++p) {
    const Rigid pose = session.pose();
    for (int b = 0; b < 2; ++b) {
      const Eigen::Vector3d centre = pose * Eigen::Vector3d(500.0 * b - 250.0, 0.0, 0.0);
      session.read("bar", std::to_string(p), b == 0 ? "A" : "B", 12, [&](int) {
        return Eigen::Vector3d(centre + (ball_radius + tip_radius) * session.random().direction());
      });
    }
  }
  return session.recording();
}

std::vector<StepScore> scores_of(const Recording& recording) {
  const auto bound = test::bind(recording, {two_balls()});
  const System system =
      make_system(bound.recording, bound.constraints, bound.recording.arm, parameters_of(bound.recording.arm));
  return score_steps(system, coarse_weights(bound.constraints, 1.0), bound.recording);
}

TEST(StepScores, FindTheStepInAnArmWithoutErrors) {
  for (const int joint : {1, 2, 3, 4}) {
    Recording recording = session(0.0);
    ASSERT_EQ(recording.readings.size(), 192U);
    recording.joints.row(joint).tail(80).array() += 0.1 * units::degree;
    const auto scores = scores_of(recording);
    ASSERT_FALSE(scores.empty());
    EXPECT_EQ(scores[0].joint, joint);
    EXPECT_EQ(scores[0].order, SlipOrder::Time);
    EXPECT_EQ(scores[0].place, 112U) << joint;
    EXPECT_GT(scores[0].share, 0.9) << joint;
    EXPECT_LE(scores[0].share, 1.0 + 1e-9) << joint;
  }
}

TEST(StepScores, FindTheAngleAboveWhichAJointIsOff) {
  Recording recording = session(0.0);
  int below = 0;
  for (Eigen::Index i = 0; i < recording.joints.cols(); ++i) {
    const bool above = recording.joints(2, i) > 0.7;
    recording.joints(2, i) += above ? 0.1 * units::degree : 0.0;
    below += above ? 0 : 1;
  }
  const auto scores = scores_of(recording);
  ASSERT_FALSE(scores.empty());
  EXPECT_EQ(scores[0].joint, 2);
  EXPECT_EQ(scores[0].order, SlipOrder::Angle);
  EXPECT_EQ(scores[0].place, static_cast<std::size_t>(below));
}

// Which errors of the arm, within the prior, blur the place by no more than the touches of one ball.
TEST(StepScores, FindTheJointBehindTheArmsErrors) {
  Recording recording = session(0.3);
  recording.joints.row(2).tail(80).array() += 1.0 * units::degree;
  const auto scores = scores_of(recording);
  ASSERT_FALSE(scores.empty());
  EXPECT_EQ(scores[0].joint, 2);
  EXPECT_EQ(scores[0].order, SlipOrder::Time);
  EXPECT_NEAR(static_cast<double>(scores[0].place), 112.0, 12.0);
}

TEST(StepScores, AreNoneOfReadingsThatDetermineNoCentre) {
  Recording recording = session(0.0);
  recording.readings.resize(2);
  recording.joints.conservativeResize(Eigen::NoChange, 2);
  EXPECT_TRUE(scores_of(recording).empty());
}

}  // namespace
}  // namespace artcal
