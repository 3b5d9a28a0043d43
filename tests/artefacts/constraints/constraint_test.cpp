#include "artefacts/constraints/constraint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/recording/recording_file.h"
#include "artefacts/constraints/bound_recording.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::replaced;
using ::testing::SizeIs;
using ::testing::StartsWith;

// A bar of two seats and a ball, a plate of known points, a draw wire, and another instrument.
constexpr std::string_view bar =
    "schema = \"artcal-artefact/1\"\nname = \"bar\"\nunits = { length = \"mm\" }\nexpansion_per_K = 10e-6\n"
    "[[feature]]\nname = \"A\"\nkind = \"point\"\n"
    "[[feature]]\nname = \"B\"\nkind = \"point\"\n"
    "[[feature]]\nname = \"ball\"\nkind = \"sphere\"\ndiameter = 20\n"
    "[[feature]]\nname = \"far\"\nkind = \"point\"\n"
    "[[distance]]\nbetween = [\"A\", \"B\"]\nvalue = 1000\nU = 0.002\nk = 2\n"
    "[[distance]]\nbetween = [\"B\", \"far\"]\nvalue = 500\nU = 0.004\nk = 2\n";
constexpr std::string_view plate =
    "schema = \"artcal-artefact/1\"\nname = \"plate\"\nunits = { length = \"mm\" }\nexpansion_per_K = 20e-6\n"
    "[[feature]]\nname = \"P\"\nkind = \"point\"\nat = [100, 0, 0]\n"
    "[[feature]]\nname = \"Q\"\nkind = \"point\"\nat = [0, 200, 0]\n"
    "[[feature]]\nname = \"R\"\nkind = \"sphere\"\ndiameter = 10\nat = [0, 0, 400]\n"
    "[[feature]]\nname = \"loose\"\nkind = \"point\"\n"
    "[[distance]]\nbetween = [\"P\", \"Q\"]\nvalue = 223.6068\nU = 0.002\nk = 2\n";
constexpr std::string_view wire =
    "schema = \"artcal-artefact/1\"\nname = \"wire\"\nunits = { length = \"mm\" }\n"
    "[[feature]]\nname = \"anchor\"\nkind = \"anchor\"\nU = 0.05\nk = 2\n";
constexpr std::string_view tracker =
    "schema = \"artcal-artefact/1\"\nname = \"tracker\"\nframe = \"base\"\nunits = { length = \"mm\" }\n"
    "[[feature]]\nname = \"tip\"\nkind = \"coordinates\"\nU = 0.02\nk = 2\n";

/// The recording of tests/support/example_recording.h, on these artefacts.
class ConstraintTest : public ::testing::Test {
 protected:
  ConstraintTest() {
    example_.arm = replaced(example_.arm, "radius = 3\n",
                            "radius = 3\n[[probe]]\nname = \"star\"\nlx = 1\nly = 2\nlz = 3\nradius = 1.5\n");
    (void)folder_.write("bar.toml", bar);
    (void)folder_.write("plate.toml", plate);
    (void)folder_.write("wire.toml", wire);
    (void)folder_.write("tracker.toml", tracker);
  }
  /// `artefacts` as they stand in the recording, such as "\"bar.toml\"".
  Expected<Constraints> bind(const std::string& artefacts, const std::string& readings) {
    testing::ExampleRecording with = example_;
    with.readings = readings;
    with.recording = replaced(with.recording, "arm = ", "artefacts = [" + artefacts + "]\narm = ");
    auto read = read_recording(with.write(folder_));
    if (!read) {
      return tl::unexpected(read.error());
    }
    return bind_recording(std::move(*read)).map([&](BoundRecording&& bound) {
      recording_ = std::move(bound.recording);
      return std::move(bound.constraints);
    });
  }
  std::string refusal(const std::string& artefacts, const std::string& readings) {
    const auto bound = bind(artefacts, readings);
    return bound ? "accepted" : bound.error().text().substr(folder_.path().string().size() + 1);
  }
  Constraints bound(const std::string& artefacts, const std::string& readings) {
    auto constraints = bind(artefacts, readings);
    EXPECT_TRUE(constraints) << constraints.error().text();
    return constraints ? std::move(*constraints) : Constraints{};
  }
  testing::ExampleRecording example_;
  testing::TemporaryFolder folder_;
  Recording recording_;
};

const std::string all = "\"bar.toml\", \"plate.toml\", \"wire.toml\", \"tracker.toml\"";

TEST_F(ConstraintTest, BindsSeveralArtefactsPlacementsAndProbesOfOneRecording) {
  const Constraints c = bound(all,
                              "artefact,placement,feature,probe,length,ref_x,ref_y,ref_z,q1,q2\n"
                              "bar,1,A,ball,,,,,1,2\n"
                              "bar,1,ball,ball,,,,,3,4\n"
                              "bar,1,ball,star,,,,,5,6\n"
                              "bar,2,A,star,,,,,7,8\n"
                              "plate,1,P,ball,,,,,9,10\n"
                              "wire,1,anchor,ball,321.5,,,,11,12\n"
                              "tracker,1,tip,ball,,7,8,9,13,14\n"
                              "bar,1,A,ball,,,,,15,16\n");
  ASSERT_THAT(c.features, SizeIs(6)) << "in order of appearance";
  EXPECT_EQ(name_of(c.features[0], c, recording_).artefact, "bar");
  EXPECT_EQ(name_of(c.features[0], c, recording_).placement, "1");
  EXPECT_EQ(name_of(c.features[0], c, recording_).feature, "A");
  EXPECT_THAT(c.features[0].readings, ElementsAre(0, 7));
  EXPECT_TRUE(c.features[0].is<Coincide>());
  EXPECT_EQ(c.features[0].location, Location::Unknown);
  EXPECT_EQ(c.features[0].dimension(), 3);
  EXPECT_THAT(c.features[0].known, IsEmpty());

  ASSERT_TRUE(c.features[1].is<OnBall>());
  EXPECT_EQ(c.features[1].as<OnBall>()->radius, 10.0);
  EXPECT_EQ(c.features[1].shared_radius(), std::nullopt) << "its certificate states no uncertainty";
  EXPECT_EQ(c.features[1].dimension(), 1);

  EXPECT_EQ(c.features[2].placement, recording_.placements.find("2"));
  EXPECT_EQ(c.features[3].location, Location::Posed);
  EXPECT_THAT(c.features[3].known, ElementsAre(Eigen::Vector3d(100, 0, 0)));

  EXPECT_EQ(c.features[4].location, Location::Unknown);
  ASSERT_TRUE(c.features[4].is<AtDistance>());
  EXPECT_THAT(c.features[4].as<AtDistance>()->distances, ElementsAre(321.5));
  EXPECT_EQ(c.features[4].u, 0.025) << "U/k";

  EXPECT_EQ(c.features[5].location, Location::Base);
  EXPECT_THAT(c.features[5].known, ElementsAre(Eigen::Vector3d(7, 8, 9)));
  EXPECT_EQ(c.features[5].u, 0.01);
  EXPECT_EQ(c.features[5].group, std::nullopt);

  EXPECT_EQ(c.reading_residual_count(), 3 * 2 + 2 + 3 + 3 + 1 + 3);
  EXPECT_EQ(c.unknown_count(), 3 + 3 + 3 + 6 + 3);
  EXPECT_THAT(c.warnings, IsEmpty());
  EXPECT_EQ(recording_.inputs.size(), 3u + 4u) << "the artefacts are inputs of the result";
}

TEST_F(ConstraintTest, OneArtefactAndOneFeatureNeedNoNames) {
  const Constraints c = bound("\"wire.toml\"", "length,q1,q2,probe\n10,1,2,ball\n11,3,4,ball\n");
  ASSERT_THAT(c.features, SizeIs(1));
  EXPECT_THAT(c.features[0].readings, ElementsAre(0, 1));
}

TEST_F(ConstraintTest, RefusesWhatNobodyDescribedWithItsLine) {
  EXPECT_THAT(refusal("\"bar.toml\"", "artefact,feature,probe,q1,q2\nbar,A,ball,1,2\nbat,A,ball,1,2\n"),
              StartsWith("readings.csv:3: the reading names the artefact \"bat\", expected one of: bar"));
  EXPECT_THAT(
      refusal("\"bar.toml\"", "feature,probe,q1,q2\nA,ball,1,2\n\n# note\nZ,ball,1,2\n"),
      StartsWith("readings.csv:5: the reading names the feature \"Z\", which the artefact \"bar\" does not have, "
                 "expected one of: A, B, ball, far"));
  EXPECT_THAT(refusal("\"bar.toml\"", "probe,q1,q2\nball,1,2\n"),
              StartsWith("readings.csv:2: the reading names no feature, expected one of the artefact \"bar\": A, B,"));
  EXPECT_THAT(refusal("\"bar.toml\", \"plate.toml\"", "artefact,feature,probe,q1,q2\nbar,A,ball,1,2\n,A,ball,1,2\n"),
              StartsWith("readings.csv:3: the reading names no artefact, and there are several: bar, plate"));
}

TEST_F(ConstraintTest, RefusesAnAnchorWithoutALength) {
  EXPECT_THAT(
      refusal("\"wire.toml\"", "feature,probe,length,q1,q2\nanchor,ball,5,1,2\nanchor,ball,,1,2\n"),
      StartsWith("readings.csv:3: the feature \"anchor\" is an anchor to which a length is measured, expected a "
                 "number above zero in the column length"));
  EXPECT_THAT(refusal("\"wire.toml\"", "feature,probe,length,q1,q2\nanchor,ball,-5,1,2\n"),
              StartsWith("readings.csv:2: "));
  EXPECT_THAT(refusal("\"wire.toml\"", "feature,probe,q1,q2\nanchor,ball,1,2\n"), HasSubstr("the column length"));
}

TEST_F(ConstraintTest, RefusesCoordinatesThatAreMissing) {
  EXPECT_THAT(
      refusal("\"tracker.toml\"", "probe,ref_x,ref_y,ref_z,q1,q2\nball,1,2,3,4,5\nball,1,2,,4,5\n"),
      StartsWith("readings.csv:3: the feature \"tip\" wants the tip's coordinates with each reading, but ref_x, "
                 "ref_y, ref_z are missing here"));
  EXPECT_THAT(refusal("\"tracker.toml\"", "probe,q1,q2\nball,4,5\n"),
              StartsWith("readings.csv:2: the feature \"tip\""));
}

TEST_F(ConstraintTest, RefusesArtefactsThatCannotBeToldApartOrRead) {
  EXPECT_THAT(refusal("\"bar.toml\", \"bar.toml\"", "artefact,feature,probe,q1,q2\nbar,A,ball,1,2\n"),
              StartsWith("bar.toml: two artefacts of this recording are called \"bar\""));
  EXPECT_THAT(refusal("\"none.toml\"", "feature,probe,q1,q2\nA,ball,1,2\n"), StartsWith("none.toml: there is no such"));
  EXPECT_THAT(refusal("", "feature,probe,q1,q2\nA,ball,1,2\n"),
              StartsWith("recording.toml: the recording names no artefact, expected artefacts = ["));
}

TEST_F(ConstraintTest, ShowsHostileLabelsHarmlessly) {
  const std::string message = refusal("\"bar.toml\"", "feature,probe,q1,q2\n" + std::string(5000, 'x') + ",ball,1,2\n");
  EXPECT_LT(message.size(), 250u);
  EXPECT_THAT(message, HasSubstr("…\""));
}

// 10e-6/K over 1000 mm at 25 °C is 50 µm; the mean of a placement's readings counts.
TEST_F(ConstraintTest, CertifiedLengthsGrowWithTheTemperatureOfTheirPlacement) {
  const Constraints c = bound("\"bar.toml\"",
                              "placement,feature,probe,temperature,q1,q2\n"
                              "warm,A,ball,24,1,2\n"
                              "warm,B,ball,26,3,4\n"
                              "warm,ball,ball,25,3,4\n"
                              "warm,ball,ball,,13,4\n"
                              "cold,A,ball,10,5,6\n"
                              "cold,B,ball,10,7,8\n"
                              "unread,A,ball,,9,10\n"
                              "unread,B,ball,,11,12\n");
  ASSERT_THAT(c.distances, SizeIs(3));
  EXPECT_NEAR(c.distances[0].value, 1000.05, 1e-9);
  EXPECT_NEAR(c.distances[1].value, 999.9, 1e-9);
  EXPECT_EQ(c.distances[2].value, 1000.0) << "no temperature read: as at the reference";
  EXPECT_EQ(c.distances[0].u, 0.001);
  EXPECT_NEAR(c.features[2].as<OnBall>()->radius.value(), 10.0005, 1e-12);
  EXPECT_THAT(c.warnings, IsEmpty());
}

TEST_F(ConstraintTest, CertifiedCoordinatesGrowWithTheTemperature) {
  const Constraints c =
      bound("\"plate.toml\"", "feature,probe,temperature,q1,q2\nP,ball,30,1,2\nQ,ball,30,3,4\nR,star,30,5,6\n");
  // 20e-6/K over 10 K.
  EXPECT_NEAR(c.features[0].known[0].x(), 100.02, 1e-12);
  EXPECT_NEAR(c.features[1].known[0].y(), 200.04, 1e-12);
  EXPECT_NEAR(c.features[2].known[0].z(), 400.08, 1e-12);
  EXPECT_NEAR(c.features[2].as<OnBall>()->radius.value(), 5.001, 1e-12);
  EXPECT_NEAR(c.distances[0].value, 223.6068 * 1.0002, 1e-9);
}

TEST_F(ConstraintTest, WhatAnotherInstrumentMeasuredDoesNotGrow) {
  (void)folder_.write("tracker.toml", replaced(std::string(tracker), "units", "expansion_per_K = 10e-6\nunits"));
  (void)folder_.write("wire.toml", replaced(std::string(wire), "units", "expansion_per_K = 10e-6\nunits"));
  const Constraints c = bound("\"tracker.toml\", \"wire.toml\"",
                              "artefact,probe,temperature,length,ref_x,ref_y,ref_z,q1,q2\n"
                              "tracker,ball,40,,1000,2000,3000,1,2\nwire,ball,40,500,,,,1,2\n");
  EXPECT_EQ(c.features[0].known[0], Eigen::Vector3d(1000, 2000, 3000));
  EXPECT_EQ(c.features[1].as<AtDistance>()->distances[0], 500.0);
}

TEST_F(ConstraintTest, WarnsWhereALengthShouldHaveGrownButNobodySaidHowMuch) {
  const std::string readings = "placement,feature,probe,temperature,q1,q2\n1,A,ball,20.1,1,2\n2,A,ball,17.5,3,4\n";
  EXPECT_THAT(bound("\"bar.toml\"", readings).warnings, IsEmpty()) << "the expansion is stated";
  (void)folder_.write("bar.toml", replaced(std::string(bar), "expansion_per_K = 10e-6\n", ""));
  const Constraints c = bound("\"bar.toml\"", readings);
  EXPECT_THAT(c.warnings, ElementsAre("the artefact \"bar\" was used 2.5 K away from 20 degC, but its file states no "
                                      "expansion_per_K: its lengths were not corrected"));
  EXPECT_THAT(bound("\"bar.toml\"", "feature,probe,temperature,q1,q2\nA,ball,20.4,1,2\n").warnings, IsEmpty())
      << "half a kelvin is let pass";
  EXPECT_THAT(bound("\"wire.toml\"", "probe,temperature,length,q1,q2\nball,30,5,1,2\n").warnings, IsEmpty())
      << "a draw wire has no certified length";
}

TEST_F(ConstraintTest, GroupsWhatADistanceTiesTogether) {
  const Constraints c =
      bound("\"bar.toml\"",
            "placement,feature,probe,q1,q2\n"
            "1,A,ball,1,2\n1,ball,ball,2,2\n1,B,ball,3,2\n1,far,ball,4,2\n2,A,ball,5,2\n2,B,ball,6,2\n");
  // 1: {A, B, far} tied by two distances, {ball} alone; 2: {A, B}.
  ASSERT_THAT(c.features, SizeIs(6));
  ASSERT_THAT(c.groups, SizeIs(3));
  EXPECT_EQ(c.groups[0].size, 9);
  EXPECT_EQ(c.groups[1].size, 3);
  EXPECT_EQ(c.groups[2].size, 6);
  std::vector<std::pair<int, int>> places;
  for (const FeatureConstraint& feature : c.features) {
    ASSERT_TRUE(feature.group);
    places.emplace_back(*feature.group, feature.offset);
    EXPECT_FALSE(c.groups[*feature.group].has_pose);
  }
  EXPECT_THAT(places, ElementsAre(std::pair(0, 0), std::pair(1, 0), std::pair(0, 3), std::pair(0, 6), std::pair(2, 0),
                                  std::pair(2, 3)));
  ASSERT_THAT(c.distances, SizeIs(3));
  EXPECT_EQ(c.binding_distance_count(), 3);
  EXPECT_EQ(c.distances[0].first, 0);
  EXPECT_EQ(c.distances[0].second, 2);
}

TEST_F(ConstraintTest, ADistanceWithOneEndReadIsNone) {
  const Constraints c = bound("\"bar.toml\"", "placement,feature,probe,q1,q2\n1,A,ball,1,2\n2,B,ball,1,2\n");
  EXPECT_THAT(c.distances, IsEmpty());
  EXPECT_THAT(c.groups, SizeIs(2));
}

TEST_F(ConstraintTest, APlateIsOneGroupWithItsPose) {
  const Constraints c = bound(
      "\"plate.toml\"", "placement,feature,probe,q1,q2\n1,P,ball,1,2\n1,loose,ball,2,2\n1,Q,ball,3,2\n2,P,ball,4,2\n");
  // The loose point hangs on nothing: a group of its own.
  ASSERT_THAT(c.groups, SizeIs(3));
  EXPECT_TRUE(c.groups[0].has_pose);
  EXPECT_EQ(c.groups[0].size, 5) << "two points do not see how the plate turns about their line";
  EXPECT_EQ(c.features[2].group, 0);
  EXPECT_FALSE(c.groups[1].has_pose);
  EXPECT_TRUE(c.groups[2].has_pose);
  ASSERT_THAT(c.distances, SizeIs(1));
  EXPECT_FALSE(c.distances[0].binds) << "their coordinates say it already";
  EXPECT_EQ(c.binding_distance_count(), 0);
}

TEST_F(ConstraintTest, WithoutFeaturesTheRestIsBoundAnew) {
  const Constraints c = bound("\"bar.toml\"",
                              "placement,feature,probe,q1,q2\n"
                              "1,A,ball,1,2\n1,B,ball,2,2\n2,A,ball,3,2\n2,B,ball,4,2\n2,far,ball,5,2\n");
  const Constraints without_placement = without_features(c, {true, true, false, false, false});
  ASSERT_THAT(without_placement.features, SizeIs(3));
  EXPECT_THAT(without_placement.features[0].readings, ElementsAre(2)) << "readings keep their numbers";
  ASSERT_THAT(without_placement.groups, SizeIs(1));
  EXPECT_EQ(without_placement.groups[0].size, 9);
  ASSERT_THAT(without_placement.distances, SizeIs(2));
  EXPECT_EQ(without_placement.distances[0].first, 0);
  EXPECT_EQ(without_placement.distances[0].second, 1);
  EXPECT_EQ(without_placement.distances[1].second, 2);

  // Without the middle one, what hung on both its distances falls apart.
  const Constraints without_middle = without_features(c, {true, true, false, true, false});
  EXPECT_THAT(without_middle.groups, SizeIs(2));
  EXPECT_THAT(without_middle.distances, IsEmpty());
  EXPECT_EQ(without_middle.features[1].offset, 0);

  EXPECT_EQ(without_features(c, std::vector<bool>(5, false)).unknown_count(), c.unknown_count());
  EXPECT_THAT(without_features(c, std::vector<bool>(5, true)).groups, IsEmpty());
}

}  // namespace
}  // namespace artcal
