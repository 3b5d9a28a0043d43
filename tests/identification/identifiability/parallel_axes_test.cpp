// A UR10e of a factory calibration (Universal_Robots_ROS2_Driver, ur_calibration/doc/algorithm.rst, BSD-3-Clause): its
// axes 2, 3 and 4 are parallel to some hundredths of a degree, and its d are 440 m that cancel. Read by an independent
// forward kinematics, identified from the nominal arm.
#include "identification/identifiability/parallel_axes.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/recordings.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

constexpr double right = std::numbers::pi / 2;

Arm with_tip(Arm arm) {
  Probe probe;
  probe.tip_in_last = {40.0, 0.0, 100.0};
  arm.probes.push_back(probe);
  return arm;
}

Arm nominal_ur10e() {
  Arm arm;
  arm.name = "UR10e";
  const double table[6][3] = {{0.0, 180.7, right},  {-612.7, 0.0, 0.0},    {-571.55, 0.0, 0.0},
                              {0.0, 174.15, right}, {0.0, 119.85, -right}, {0.0, 116.55, 0.0}};
  for (const auto& [a, d, alpha] : table) arm.joints.push_back({.a = a, .d = d, .alpha = alpha});
  return with_tip(arm);
}

Arm calibrated_ur10e() {
  Arm arm;
  arm.name = "UR10e, calibrated";
  const double theta[] = {-2.4147806894359e-07, 1.60233952386695,      -1.68607190752171,
                          0.0837331147700119,   -1.01260355871158e-07, 3.91986209186124e-08};
  const double a[] = {2.12234865571206e-05,  0.0193171326277006,    -0.569251663611088,
                      -4.61409023720934e-05, -6.39280053471802e-05, 0.0};
  const double d[] = {0.180539811714259, 439.140974079901,  -446.027059806332,
                      7.0603368964236,   0.119811341150314, 0.115670917257426};
  const double alpha[] = {1.57014608044242, 0.0013941666682559, 0.00693818880325995,
                          1.56998468543761, -1.57038519649543,  0.0};
  for (int i = 0; i < 6; ++i) {
    arm.joints.push_back({.a = 1000.0 * a[i], .d = 1000.0 * d[i], .theta = theta[i], .alpha = alpha[i]});
  }
  return with_tip(arm);
}

test::Bound read_coordinates(const Arm& truth, const Arm& nominal, int count) {
  RandomStream random(6, "UR10e");
  Recording recording;
  recording.name = "UR10e";
  recording.arm = nominal;
  recording.files = {"planted"};
  recording.artefacts.index_of("tracker");
  recording.joints.resize(6, count);
  const testing::ArmNumbers<double> numbers(truth);
  for (int i = 0; i < count; ++i) {
    std::vector<double> q(6);
    for (double& angle : q) angle = random.uniform(-std::numbers::pi, std::numbers::pi);
    recording.joints.col(i) = Eigen::VectorXd::Map(q.data(), 6);
    Reading reading{};
    reading.placement = recording.placements.index_of("1");
    reading.feature = recording.features.index_of("T");
    reading.orientation = recording.orientations.index_of("");
    reading.repeat = recording.repeats.index_of("");
    reading.temperature = std::numeric_limits<double>::quiet_NaN();
    reading.reference = testing::tip_in_base(numbers, q, 0);
    reading.line = i + 1;
    recording.readings.push_back(reading);
  }
  Artefact tracker;
  tracker.name = "tracker";
  tracker.frame = CoordinateFrame::Base;
  CertifiedFeature target;
  target.name = "T";
  target.kind = FeatureKind::Coordinates;
  tracker.features.push_back(target);
  return test::bind(std::move(recording), {tracker});
}

TEST(ParallelAxes, AreNamed) {
  EXPECT_EQ(parallel_axes(nominal_ur10e()), "axes 2 and 3 (0 deg), axes 3 and 4 (0 deg)");
  EXPECT_EQ(parallel_axes(calibrated_ur10e()), "axes 2 and 3 (0.08 deg), axes 3 and 4 (0.4 deg)");
  EXPECT_EQ(parallel_axes(test::gao_arm()), "");
  Arm with_beta = nominal_ur10e();
  with_beta.joints[1].has_beta = true;
  EXPECT_EQ(parallel_axes(with_beta), "axes 3 and 4 (0 deg)");
  Arm modified = nominal_ur10e();
  modified.convention = Convention::Modified;  // alpha carries the index of the link before
  EXPECT_EQ(parallel_axes(modified), "axes 1 and 2 (0 deg), axes 2 and 3 (0 deg), axes 5 and 6 (0 deg)");
}

// With Hayati's angles the planted readings are met to rounding of coordinates beside d of 440 m.
TEST(ParallelAxes, WhatHayatisAngleGivesIsComputed) {
  const test::Bound bound = read_coordinates(calibrated_ur10e(), nominal_ur10e(), 150);
  IdentifyOptions options;
  options.leave_out = false;
  const auto nominal = evaluate(bound.recording, bound.constraints, bound.recording.arm);
  ASSERT_TRUE(nominal);
  const std::string note = note_on_parallel_axes(bound.recording, bound.constraints, options, *nominal);
  EXPECT_THAT(note, HasSubstr("axes 2 and 3 (0 deg), axes 3 and 4 (0 deg)"));
  EXPECT_THAT(note, HasSubstr("With --model dh+hayati the residuals are"));
  EXPECT_THAT(note, HasSubstr("100 % less"));
  options.model = {ParameterGroup::Hayati};
  EXPECT_LT(test::identified(bound, options).after.overall.rms, 1e-7);
  EXPECT_EQ(note_on_parallel_axes(bound.recording, bound.constraints, options, *nominal), "");
}

// An identified arm with d of 440 m that cancel is as good a start as any.
TEST(ParallelAxes, AnArmWhoseDCancelIsNotRefusedForItsReach) {
  const Arm arm = calibrated_ur10e();
  const test::Bound bound = read_coordinates(arm, arm, 100);
  IdentifyOptions options;
  options.leave_out = false;
  options.noise.reading = 0.01;
  EXPECT_LT(test::identified(bound, options).after.overall.rms, 1e-5);
}

}  // namespace
}  // namespace artcal
