// A simulated AACMM on a sphere plate, on two seats and on a plane, alone and together with the ball bar of
// examples/ball-bar, judged against the arm that an independent simulator made the readings with
// (tests/reference/aacmm-simulated/NOTE.md).
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include "acquisition/arm/arm_file.h"
#include "tests/support/recordings.h"
#include "tests/support/simulated_session.h"

namespace artcal {
namespace {

std::string reference(const std::string& name) {
  return std::string(ARTCAL_SOURCE_DIR) + "/tests/reference/aacmm-simulated/" + name;
}

class AacmmSimulated : public ::testing::Test {
 protected:
  static test::Bound session(const std::string& name) {
    return test::read_bound(name == "ball-bar" ? test::example("ball-bar/recording.toml")
                                               : reference(name + "/recording.toml"));
  }
  /// Several sessions of the one arm as one recording.
  static test::Bound together(const std::vector<std::string>& names) {
    test::Bound all = session(names.front());
    for (std::size_t i = 1; i < names.size(); ++i) {
      all = test::joined(all, session(names[i]));
    }
    return all;
  }
  /// Error of 20,000 random lengths by the identified arm, µm rms.
  [[nodiscard]] double length_rms(const Identification& result) const {
    return 1000.0 * testing::length_rms(truth_, result.arm, 20000);
  }
  static IdentifyOptions by_posture(const test::Bound& bound) {
    IdentifyOptions options;
    options.noise = bound.recording.noise;
    options.leave_out = false;
    return options;
  }

  Arm truth_ = read_arm_file(reference("truth-arm.toml"))->arm;
};

// The NOTE's program: 15 µm a reading, every ball's centre unknown in every placement, all distances certified. On
// a flat plate these hardly tell how far a ball is out of the plane.
TEST_F(AacmmSimulated, TheSpherePlateAsTheNoteHasIt) {
  test::Bound plate = session("sphere-plate");
  Artefact& artefact = plate.constraints.artefacts[0];
  for (int i = 0; i < 25; ++i) {
    for (int j = 0; j < i; ++j) {
      artefact.distances.push_back({j, i, (*artefact.features[i].at - *artefact.features[j].at).norm(), 0.0004});
    }
  }
  for (auto& feature : artefact.features) feature.at.reset();
  plate = test::bind(std::move(plate.recording), plate.constraints.artefacts);
  IdentifyOptions options;
  options.noise.reading = 0.015;
  options.leave_out = false;
  const Identification result = test::identified(plate, options);
  RecordProperty("distances only",
                 std::to_string(length_rms(result)) + ", " + std::to_string(result.after.overall.rms));
  EXPECT_NEAR(length_rms(result), 3.37, 0.15);
  EXPECT_EQ(result.coupling.rank, 21);
}

// With the coordinates, as artcal reads the plate.
TEST_F(AacmmSimulated, TheSpherePlateByItsCoordinates) {
  const test::Bound plate = session("sphere-plate");
  EXPECT_EQ(plate.constraints.shared.size(), 75u);
  IdentifyOptions options;
  options.noise.reading = 0.015;
  options.leave_out = false;
  const Identification result = test::identified(plate, options);
  EXPECT_LT(length_rms(result), 3.7);
  EXPECT_NEAR(result.after.overall.rms, 0.00909, 0.0002);
  EXPECT_EQ(result.coupling.rank, 21);
}

TEST_F(AacmmSimulated, TheSeatsAsTheNoteHasThem) {
  IdentifyOptions options;
  options.noise.reading = 0.015;
  options.leave_out = false;
  const Identification result = test::identified(session("seat"), options);
  EXPECT_NEAR(length_rms(result), 6.63, 0.3);
  // Distances here, 8.55 µm rms a coordinate in the NOTE.
  EXPECT_NEAR(result.after.overall.rms / std::sqrt(3.0), 0.00855, 0.0003);
}

TEST_F(AacmmSimulated, ThePlaneAloneCannotTellTheScale) {
  const test::Bound plane = session("plane");
  const auto result = identify(plane.recording, plane.constraints);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::NoSolution);
  EXPECT_THAT(result.error().message, ::testing::HasSubstr("no calibrated length"));
  const auto coupling = analyse_coupling(plane.recording, plane.constraints, plane.recording.arm);
  ASSERT_TRUE(coupling);
  EXPECT_EQ(coupling->rank, 20);
  EXPECT_EQ(coupling->scale, ScaleState::Unidentifiable);
}

TEST_F(AacmmSimulated, ByPostureEachIsFoundWithinItsUncertainty) {
  // One draw of noise each: of the plate's readings, other weights happen to do better (3.5).
  for (const auto& [name, limit] : {std::pair{"ball-bar", 5.0}, {"sphere-plate", 4.6}, {"seat", 6.63}}) {
    const test::Bound bound = session(name);
    const Identification result = test::identified(bound, by_posture(bound));
    RecordProperty(name, std::to_string(length_rms(result)));
    EXPECT_LT(length_rms(result), limit) << name;
    Eigen::VectorXd deviation(static_cast<Eigen::Index>(result.free.size()));
    for (Eigen::Index i = 0; i < deviation.size(); ++i) {
      const Parameter& parameter = result.parameters[result.free[i]].parameter;
      deviation[i] = value(result.arm, parameter) - value(truth_, parameter);
    }
    const double chi_squared = deviation.dot(result.covariance.ldlt().solve(deviation));
    EXPECT_GT(chi_squared, 5.9) << name;  // 0.1 % and 99.9 % of χ² with 21 degrees of freedom
    EXPECT_LT(chi_squared, 46.8) << name;
    EXPECT_GT(result.chi_squared, result.chi_squared_low) << name;
    EXPECT_LT(result.chi_squared, result.chi_squared_high) << name;
  }
}

TEST_F(AacmmSimulated, ThePlaneAddsToEachOfTheOthers) {
  for (const std::string name : {"ball-bar", "sphere-plate", "seat"}) {
    const test::Bound alone = session(name);
    const test::Bound both = together({name, "plane"});
    const double before = length_rms(test::identified(alone, by_posture(alone)));
    const Identification result = test::identified(both, by_posture(both));
    const double after = length_rms(result);
    RecordProperty(name + " alone, with plane", std::to_string(before) + ", " + std::to_string(after));
    EXPECT_LT(after, 1.1 * before) << name;  // one draw of noise
    EXPECT_LT(result.chi_squared, result.chi_squared_high) << name;
  }
}

TEST_F(AacmmSimulated, AllInOneRecording) {
  const test::Bound all = together({"ball-bar", "sphere-plate", "seat", "plane"});
  IdentifyOptions options = by_posture(all);
  const Identification result = test::identified(all, options);
  RecordProperty("all", std::to_string(length_rms(result)));
  EXPECT_LT(length_rms(result), 2.5);
  EXPECT_GT(result.chi_squared, result.chi_squared_low);
  EXPECT_LT(result.chi_squared, result.chi_squared_high);
  EXPECT_EQ(result.after.artefacts.size(), 4u);
}

TEST_F(AacmmSimulated, PlacementsOfAllKindsAreLeftOut) {
  const test::Bound both = together({"seat", "plane"});
  IdentifyOptions options = by_posture(both);
  options.leave_out = true;
  const Identification result = test::identified(both, options);
  EXPECT_EQ(result.left_out.size(), 11u) << "placements";
  for (const LeftOut& left : result.left_out) {
    EXPECT_EQ(left.refusal, "");
    EXPECT_LT(left.deviation.rms, 0.025);
  }
}

}  // namespace
}  // namespace artcal
