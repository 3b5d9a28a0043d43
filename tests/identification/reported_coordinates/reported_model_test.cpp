// The arm of MPE 2018 (article 1760190, Table 2): its reported coordinates are planted by 4 x 4 matrices, rounded to
// 1 um, which is 0.29 um rms.
#include "identification/reported_coordinates/reported_model.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "core/units.h"
#include "tests/support/forward_kinematics.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

Arm arm_of_the_paper() {
  constexpr double table[6][4] = {{-89.9683, -0.0226, 0.0, 376.5},      {-90.0312, 62.1163, 0.0040, -0.0525},
                                  {90.0071, -0.0061, 0.0466, 750.7422}, {-90.0338, 62.1025, -0.0374, 0.0597},
                                  {90.0373, 0.0049, 0.0127, 500.5566},  {-90.0, 0.0, -0.0060, 15.0695}};
  Arm arm;
  arm.name = "MPE 2018";
  for (const auto& [alpha, a, theta, d] : table) {
    arm.joints.push_back({.a = a, .d = d, .theta = theta * units::degree, .alpha = alpha * units::degree});
  }
  arm.probes.push_back({"tip", {0.0, 0.0, 97.8110}, 0.0, true});
  return arm;
}

// Off by up to 10 mm and 5 degrees.
Arm rough(Arm arm, RandomStream& random) {
  for (const Parameter& parameter : parameters_of(arm)) {
    const double size = parameter.is_length() ? 10.0 : 5.0 * units::degree;
    set_value(arm, parameter, value(arm, parameter) + size * random.uniform(-1.0, 1.0));
  }
  return arm;
}

Recording reported(const Arm& truth, const Arm& nominal, int count, RandomStream& random) {
  Recording recording;
  recording.name = "reported";
  recording.arm = nominal;
  recording.files = {"readings.csv"};
  const auto joints = static_cast<Eigen::Index>(truth.joints.size());
  recording.joints.resize(joints, count);
  const testing::ArmNumbers<double> numbers(truth);
  for (int i = 0; i < count; ++i) {
    std::vector<double> q(truth.joints.size());
    for (double& angle : q) angle = random.uniform(-3.0, 3.0);
    recording.joints.col(i) = Eigen::VectorXd::Map(q.data(), joints);
    Reading reading{};
    reading.temperature = Reading::not_read;
    reading.artefact = recording.artefacts.index_of("");
    reading.placement = recording.placements.index_of("");
    reading.feature = recording.features.index_of("");
    reading.orientation = recording.orientations.index_of("");
    reading.repeat = recording.repeats.index_of("");
    reading.tip = (1e3 * testing::tip_in_base(numbers, q, 0)).array().round().matrix() / 1e3;
    reading.line = i + 2;
    recording.readings.push_back(reading);
  }
  return recording;
}

TEST(ReportedModel, OfTheMakerIsFoundToTheRoundingOfHisCoordinates) {
  RandomStream random(1, "reported");
  const Arm truth = arm_of_the_paper();
  const auto model = identify_reported_model(reported(truth, rough(truth, random), 500, random), {});
  ASSERT_TRUE(model) << model.error().text();
  EXPECT_TRUE(model->assignment.changes_nothing());
  EXPECT_EQ(model->identification.coupling.rank, 23);
  EXPECT_EQ(model->identification.coupling.parameters.size(), 25u);
  const double of_coordinate = model->identification.after.overall.rms / std::sqrt(3.0);
  EXPECT_NEAR(of_coordinate, 1e-3 / std::sqrt(12.0), 0.01e-3);  // 0.29 um
  // As good anywhere else.
  const testing::ArmNumbers<double> numbers(truth), found(model->identification.arm);
  double worst = 0.0;
  for (int i = 0; i < 100; ++i) {
    std::vector<double> q(6);
    for (double& angle : q) angle = random.uniform(-3.0, 3.0);
    worst = std::max(worst, (testing::tip_in_base(found, q, 0) - testing::tip_in_base(numbers, q, 0)).norm());
  }
  EXPECT_LT(worst, 0.5e-3);
}

// What the columns hold is not what the arm's file says: signs, unit, and in the end the order.
TEST(ReportedModel, SignsAndUnitsAreFound) {
  RandomStream random(2, "reported");
  const Arm truth = arm_of_the_paper();
  Recording recording = reported(truth, rough(truth, random), 120, random);
  recording.joints.row(1) *= -1.0;
  recording.joints.row(4) *= -1.0;
  recording.joints *= units::degree;  // radians, read as degrees
  const Recording as_read = recording;
  const auto model = identify_reported_model(recording, {});
  ASSERT_TRUE(model) << model.error().text();
  EXPECT_EQ(model->assignment.sign, (std::vector<double>{1, -1, 1, 1, -1, 1}));
  EXPECT_NEAR(model->assignment.factor, 1.0 / units::degree, 1e-9);
  EXPECT_LT(model->identification.after.overall.rms, 0.6e-3);
  EXPECT_GT(model->next_best.value_or(1e9), 1.0);
  // The arm found has the signs: with the columns as they are, in the right unit.
  EXPECT_EQ(model->identification.arm.joints[1].sign, -1.0);
  const Eigen::MatrixXd columns = as_read.joints / units::degree;
  for (int i = 0; i < 20; ++i) {
    std::vector<double> q(columns.col(i).begin(), columns.col(i).end());
    const Eigen::Vector3d tip = testing::tip_in_base(testing::ArmNumbers<double>(model->identification.arm), q, 0);
    EXPECT_LT((tip - as_read.readings[static_cast<std::size_t>(i)].tip).norm(), 2e-3);
  }
}

TEST(ReportedModel, TheOrderIsFound) {
  RandomStream random(3, "reported");
  Arm truth = arm_of_the_paper();
  truth.joints.resize(4);
  truth.probes[0].tip_in_last.z() = 300.0;
  Recording recording = reported(truth, rough(truth, random), 100, random);
  recording.joints = Eigen::MatrixXd(recording.joints(std::vector<int>{2, 0, 1, 3}, Eigen::all));
  const auto model = identify_reported_model(recording, {});
  ASSERT_TRUE(model) << model.error().text();
  EXPECT_EQ(model->assignment.column, (std::vector<int>{1, 2, 0, 3}));
  EXPECT_LT(model->identification.after.overall.rms, 0.6e-3);
}

TEST(ReportedModel, WhatIsNotThereIsRefused) {
  RandomStream random(4, "reported");
  const Arm truth = arm_of_the_paper();
  Recording recording = reported(truth, truth, 100, random);
  recording.readings[7].tip.x() = Reading::not_read;
  EXPECT_THAT(identify_reported_model(recording, {}).error().text(),
              HasSubstr("readings.csv:9: the reading has no coord"));
}

}  // namespace
}  // namespace artcal
