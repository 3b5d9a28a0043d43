#include "artefacts/verification/place.h"

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A shoulder 300 mm up and a reach of 1000 mm.
class PlaceTest : public ::testing::Test {
 protected:
  PlaceTest() {
    arm.joints.resize(2);
    arm.joints[0].d = 300.0;
    arm.joints[1].a = 900.0;
    arm.joints[1].lowest = -2.0;
    arm.joints[1].highest = 2.0;
    arm.probes.resize(1);
    arm.probes[0].tip_in_last = {0.0, 0.0, 100.0};
    recording.joints.resize(2, 2);
    recording.joints << 0.0, 0.0, 1.5, 1.99;  // 1.99 rad is half a degree from the end
  }
  Place at(double x, double y, double z, const std::vector<int>& readings = {0}) const {
    return place_of({x, y, z}, recording, arm, readings);
  }
  Arm arm;
  Recording recording;
};

TEST_F(PlaceTest, OctantsAreCountedAboutTheShoulder) {
  EXPECT_EQ(at(500, 500, 400).octant, 1);
  EXPECT_EQ(at(-500, 500, 400).octant, 2);
  EXPECT_EQ(at(-500, -500, 400).octant, 3);
  EXPECT_EQ(at(500, -500, 400).octant, 4);
  EXPECT_EQ(at(500, 500, 200).octant, 5);
  EXPECT_EQ(at(500, -500, 200).octant, 8);
}

TEST_F(PlaceTest, TheReachCountsFromTheShoulder) {
  EXPECT_DOUBLE_EQ(at(600, 0, 300).share_of_reach, 0.6);
  EXPECT_DOUBLE_EQ(at(0, 0, 800).share_of_reach, 0.5);
}

TEST_F(PlaceTest, StraightAboveTheBaseIsSaid) {
  EXPECT_TRUE(at(50, 50, 900).above_base);
  EXPECT_FALSE(at(90, 90, 900).above_base);
  EXPECT_THAT(text_of(at(50, 50, 900)), HasSubstr("straight above the base"));
}

TEST_F(PlaceTest, AJointNearItsStopIsSaid) {
  EXPECT_EQ(at(500, 500, 400).joint_at_stop, 0);
  EXPECT_EQ(at(500, 500, 400, {0, 1}).joint_at_stop, 2);
  EXPECT_THAT(text_of(at(500, 500, 400, {1})), HasSubstr("joint 2 at its stop"));
}

TEST_F(PlaceTest, AnUnknownArmHasNoReach) {
  arm.joints.clear();
  recording.joints.resize(0, 2);
  const Place place = at(10, 10, 900);
  EXPECT_EQ(place.share_of_reach, 0.0);
  EXPECT_FALSE(place.above_base);
  EXPECT_THAT(text_of(place), Not(HasSubstr("reach")));
}

}  // namespace
}  // namespace artcal
