#include "app/stream/stream_format.h"

#include <numbers>

#include <gmock/gmock.h>

#include "app/stream/stream_event.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

class CountsPerTurn : public ::testing::Test {
 protected:
  Expected<StreamFormat> read(const std::string& counts) const {
    const auto path = folder_.write(
        "stream.toml",
        "schema = \"artcal-stream/1\"\nform = \"columns\"\ndelimiter = \";\"\njoints = [\"1\", \"2\", \"3\"]\n" +
            ("counts_per_turn = [" + counts + "]\n"));
    return read_stream_format(path);
  }
  std::string refusal(const std::string& counts) const {
    const auto format = read(counts);
    return format ? "" : format.error().text();
  }

 private:
  testing::TemporaryFolder folder_;
};

// A quarter, an eighth backwards, and more than a whole turn: each encoder by its own counts.
TEST_F(CountsPerTurn, TurnCountsIntoAngles) {
  const auto format = read("8192, -4096, 10000.5");
  ASSERT_TRUE(format) << format.error().text();
  EXPECT_TRUE(format->has_counts);
  const auto event = parse_event("2048;512;12500.625", *format);
  ASSERT_TRUE(event && *event);
  EXPECT_NEAR((*event)->joints[0], std::numbers::pi / 2.0, 1e-15);
  EXPECT_NEAR((*event)->joints[1], -std::numbers::pi / 4.0, 1e-15);
  EXPECT_NEAR((*event)->joints[2], 2.5 * std::numbers::pi, 1e-14);
}

TEST_F(CountsPerTurn, AreRefusedWhereTheyAreNotOneForEachJoint) {
  EXPECT_THAT(refusal("8192, 8192"), HasSubstr("2 counts per turn, expected one for each of 3 joints"));
  EXPECT_THAT(refusal("8192, 0, 8192"), HasSubstr("0 counts per turn; expected a number such as 8192"));
}

TEST_F(CountsPerTurn, SayNothingOfAPrismaticJoint) {
  Arm arm;
  arm.joints.resize(3);
  arm.joints[1].type = JointType::Prismatic;
  const auto format = read("8192, 8192, 8192");
  ASSERT_TRUE(format);
  const auto refused = for_arm(*format, arm, "stream.toml");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("joint 2 of the arm is prismatic"));
  arm.joints[1].type = JointType::Revolute;
  EXPECT_TRUE(for_arm(*format, arm, "stream.toml"));
}

}  // namespace
}  // namespace artcal
