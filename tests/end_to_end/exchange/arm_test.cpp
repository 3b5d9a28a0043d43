// artcal arm: import, export, rounding, and the maker's own model. Truth is planted by 4 x 4 matrices of the tests.
#include <cmath>
#include <numbers>
#include <regex>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "acquisition/arm/arm_file.h"
#include "core/random.h"
#include "tests/end_to_end/program.h"
#include "tests/support/forward_kinematics.h"

namespace artcal {
namespace {

using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// A column, a shoulder and a wrist about y and z, a slide, a flange; each axis as the file's author liked it.
const std::string robot = R"(<?xml version="1.0"?>
<!DOCTYPE robot SYSTEM "../secret.dtd">
<robot name="gantry arm">
  <link name="base"/><link name="column"/><link name="upper"/><link name="slide"/><link name="hand"/><link name="tool"/>
  <joint name="turn" type="revolute"><parent link="base"/><child link="column"/><origin xyz="0 0 0.3"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="shoulder" type="revolute"><parent link="column"/><child link="upper"/><origin xyz="0.1 0 0.4"/>
    <axis xyz="0 1 0"/><limit lower="-2" upper="1.5" effort="1" velocity="1"/></joint>
  <joint name="reach" type="prismatic"><parent link="upper"/><child link="slide"/><origin xyz="0.5 0.02 0"/>
    <axis xyz="1 0 0"/><limit lower="0" upper="0.4" effort="1" velocity="1"/></joint>
  <joint name="roll" type="continuous"><parent link="slide"/><child link="hand"/><origin xyz="0.1 0 0" rpy="0 1.57 0"/>
    <axis xyz="0 0 1"/></joint>
  <joint name="flange" type="fixed"><parent link="hand"/><child link="tool"/><origin xyz="0.01 0.02 0.15"/></joint>
</robot>
)";

class ArmCommand : public testing::ProgramTest {
 protected:
  // The tip by the program, mm.
  [[nodiscard]] Eigen::Vector3d tip(const std::string& arm, const std::string& joints) const {
    write("p.toml", "schema = \"artcal-recording/1\"\narm = \"" + arm +
                        "\"\nunits = { joint = \"rad\", length = \"mm\" }\nreadings = [\"p.csv\"]\n");
    write("p.csv", "q1,q2,q3,q4\n" + joints + "\n");
    const Ended ended = run({"points", "p.toml", "--json", "-"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const auto mm = nlohmann::json::parse(ended.out)["points"][0]["tip_mm"].get<std::vector<double>>();
    return Eigen::Vector3d::Map(mm.data());
  }
};

TEST_F(ArmCommand, ImportsAndExportsTheSameRobot) {
  write("robot.urdf", robot);
  const Ended in = run({"arm", "import", "robot.urdf", "-o", "arm.toml"});
  ASSERT_EQ(in.exit_code, 0) << in.err;
  EXPECT_THAT(in.out, HasSubstr("q3  reach (prismatic)"));
  EXPECT_THAT(in.out, HasSubstr("fixed joints, part of the links: flange"));
  // Column, then shoulder about y, the slide along the arm, the hand about its own z: by hand.
  const double q1 = 0.4, q2 = -0.7, q3 = 120.0, q4 = 0.9;
  using testing::slide;
  using testing::turn;
  const testing::Transform<double> expected = slide(2, 300.0) * turn(2, q1) * slide(0, 100.0) * slide(2, 400.0) *
                                              turn(1, q2) * slide(0, 500.0) * slide(1, 20.0) * slide(0, q3) *
                                              slide(0, 100.0) * turn(1, 1.57) * turn(2, q4) * slide(0, 10.0) *
                                              slide(1, 20.0) * slide(2, 150.0);
  const Eigen::Vector3d flange = expected.block<3, 1>(0, 3);
  EXPECT_LT((tip("arm.toml", "0.4,-0.7,120,0.9") - flange).norm(), 1e-9);
  ASSERT_EQ(run({"arm", "export", "arm.toml", "--urdf", "-o", "again.urdf"}).exit_code, 0);
  ASSERT_EQ(run({"arm", "import", "again.urdf", "-o", "again.toml", "-q"}).out, "");
  EXPECT_LT((tip("again.toml", "0.4,-0.7,120,0.9") - flange).norm(), 1e-9);
  const auto arm = read_arm_file(file("again.toml"));
  ASSERT_TRUE(arm);
  EXPECT_NEAR(*arm->arm.joints[1].highest, 1.5, 1e-15);
  EXPECT_NEAR(*arm->arm.joints[2].highest, 400.0, 1e-12);
}

// The tool of the robot is turned by 1.57 rad about y before its last joint: by hand, the last joint's frame is the
// tool's.
TEST_F(ArmCommand, SaysTheTipsOrientationAndWritesIt) {
  std::string turned = robot;
  turned.replace(turned.find("xyz=\"0.01 0.02 0.15\""), 20, "xyz=\"0.01 0.02 0.15\" rpy=\"0.25 -0.5 0.75\"");
  write("robot.urdf", turned);
  const Ended in = run({"arm", "import", "robot.urdf", "-o", "arm.toml"});
  ASSERT_EQ(in.exit_code, 0) << in.err;
  const std::size_t at = in.out.find("--tip-orientation ");
  ASSERT_NE(at, std::string::npos) << in.out;
  const std::string angles = in.out.substr(at + 18, in.out.find(' ', at + 18) - at - 18);
  ASSERT_EQ(run({"arm", "export", "arm.toml", "--urdf", "--tip-orientation", angles, "-o", "again.urdf"}).exit_code, 0);
  const Ended again = run({"arm", "import", "again.urdf", "-o", "again.toml"});
  // The frames of an arm's file are those of the first one, and so are the angles, to the last digits of the text.
  const std::size_t there = again.out.find("--tip-orientation ");
  ASSERT_NE(there, std::string::npos) << again.out;
  EXPECT_NEAR(std::stod(again.out.substr(there + 18)), std::stod(angles), 1e-12);
  EXPECT_THAT(run({"arm", "export", "arm.toml", "--urdf", "--tip-orientation", "1,2"}).err,
              HasSubstr("--tip-orientation takes three angles"));
}

TEST_F(ArmCommand, RefusesWhatItCannotDo) {
  write("robot.urdf", robot);
  const auto refusal = [&](const std::vector<std::string>& arguments, int code) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.exit_code, code) << ended.err;
    return ended.err;
  };
  EXPECT_THAT(refusal({"arm", "import", "robot.urdf", "-o", "robot.urdf"}, 2), HasSubstr("would be overwritten"));
  EXPECT_EQ(text_of("robot.urdf"), robot);
  EXPECT_THAT(refusal({"arm", "import", "robot.urdf", "--tip", "nail"}, 3), HasSubstr("there is no link \"nail\""));
  EXPECT_THAT(refusal({"arm", "import", "robot.urdf", "--base", "upper"}, 3),
              HasSubstr("robot.urdf: the axis of joint \"reach\" is not the z axis of the base"));
  write("two.urdf",
        std::regex_replace(robot, std::regex("<link name=\"tool\"/>"),
                           "<link name=\"tool\"/><link name=\"camera\"/><joint name=\"c\" type=\"fixed\"><parent "
                           "link=\"hand\"/><child link=\"camera\"/></joint>"));
  EXPECT_THAT(refusal({"arm", "import", "two.urdf"}, 3), HasSubstr("2 links may be meant: camera, tool"));
  write("sick.urdf", "<robot><link");
  EXPECT_THAT(refusal({"arm", "import", "sick.urdf"}, 3), HasSubstr("sick.urdf:1: this is no XML"));
  write("k.yaml", "kinematics: {shoulder: 1}\n");
  EXPECT_THAT(refusal({"arm", "import", "k.yaml"}, 3),
              HasSubstr("k.yaml:1:13: `kinematics` has no frame \"shoulder\""));
  EXPECT_THAT(refusal({"arm", "export", "robot.urdf"}, 2), HasSubstr("--urdf"));
  take("ball-bar");
  write("bent.toml", std::regex_replace(text_of("ball-bar/arm.toml"), std::regex("\\[\\[joint\\]\\]"),
                                        "[[joint]]\ngain_ppm = 3.0", std::regex_constants::format_first_only));
  EXPECT_THAT(refusal({"arm", "export", "bent.toml", "--urdf"}, 3),
              HasSubstr("bent.toml: joint 1 has gain1, which a URDF cannot express"));
}

// A step in the only length that matters: two links in a plane, stretched in all directions.
TEST_F(ArmCommand, SaysWhatRoundingCosts) {
  write("arm.toml",
        "schema = \"artcal-arm/1\"\nname = \"two\"\nconvention = \"standard\"\nunits = { length = \"mm\", angle = "
        "\"deg\" }\n[[joint]]\na = 0.0\nd = 100.004\ntheta = 0.0\nalpha = 90.0\n[[joint]]\na = 500.0\nd = 0.0\ntheta = "
        "0.0\nalpha = 0.0\n[[probe]]\nl = 100.0\nradius = 3.0\n");
  const Ended ended = run({"arm", "round", "arm.toml", "--digits", "2", "-o", "rounded.toml"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  // d1 moves every tip by 0.004 mm, and no length.
  EXPECT_THAT(ended.out, HasSubstr("moves the tip by 0.004 mm rms, 0.004 mm at most"));
  const auto rounded = read_arm_file(file("rounded.toml"));
  ASSERT_TRUE(rounded);
  EXPECT_EQ(rounded->arm.joints[0].d, 100.0);
  // MicroScribe's steps: 0.001 in is 0.0254 mm; 100.004 is nearest to 3937 of them, 99.9998.
  ASSERT_EQ(run({"arm", "round", "arm.toml", "--steps", "length=0.001in,angle=19.8arcsec", "-o", "m.toml"}).exit_code,
            0);
  EXPECT_NEAR(read_arm_file(file("m.toml"))->arm.joints[0].d, 99.9998, 1e-9);
  EXPECT_EQ(run({"arm", "round", "arm.toml"}).exit_code, 2);
  EXPECT_THAT(run({"arm", "round", "arm.toml", "--steps", "length=2"}).err, HasSubstr("--steps has \"length=2\""));
}

// What FARO's driver hands on: joint angles, and the coordinates that the arm itself shows for them.
TEST_F(ArmCommand, FindsTheMakersModel) {
  Arm truth;
  truth.name = "of the maker";
  constexpr double right = std::numbers::pi / 2;
  truth.joints = {{.a = 1.2, .d = 250.0, .alpha = -right + 0.001},
                  {.a = 40.0, .d = 0.3, .theta = 0.02, .alpha = right},
                  {.a = -0.4, .d = 400.1, .theta = 0.01, .alpha = -right},
                  {.a = 30.0, .d = 0.0, .alpha = right}};
  truth.probes.push_back({"tip", {0.0, 0.0, 300.0}, 0.0, true});
  RandomStream random(7, "maker");
  std::ostringstream rows;
  rows.precision(17);
  rows << "q1,q2,q3,q4,x,y,z\n";
  for (int i = 0; i < 60; ++i) {
    std::vector<double> q(4);
    for (double& angle : q) angle = random.uniform(-2.8, 2.8);
    const Eigen::Vector3d tip = testing::tip_in_base(testing::ArmNumbers<double>(truth), q, 0);
    rows << q[0] << ',' << q[1] << ',' << -q[2] << ',' << q[3];
    for (const double x : tip) rows << ',' << std::round(1000.0 * x) / 1000.0;
    rows << '\n';
  }
  write("readings.csv", rows.str());
  Arm stated = truth;
  stated.joints[0].d += 6.0;
  stated.joints[1].alpha += 0.05;
  stated.joints[2].theta -= 0.06;
  write("arm.toml", arm_file_text(stated, std::nullopt));
  write("recording.toml",
        "schema = \"artcal-recording/1\"\nname = \"reported\"\narm = \"arm.toml\"\nunits = { joint = \"rad\", length = "
        "\"mm\" }\nreadings = [\"readings.csv\"]\n");
  const Ended ended = run({"arm", "from-coordinates", "recording.toml", "-o", "found.toml"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("joints that count the other way than the arm's file says: 3"));
  EXPECT_THAT(ended.out, HasSubstr("um rms a coordinate"));
  const auto found = read_arm_file(file("found.toml"));
  ASSERT_TRUE(found) << found.error().text();
  EXPECT_EQ(found->arm.joints[2].sign, -1.0);
  EXPECT_NEAR(found->arm.joints[0].d, 250.0, 0.002);
  EXPECT_THAT(run({"arm", "from-coordinates", "recording.toml", "--hold", "nothing"}).err, HasSubstr("nothing"));
  EXPECT_EQ(run({"arm", "from-coordinates", "recording.toml", "-o", "readings.csv"}).exit_code, 2);
}

}  // namespace
}  // namespace artcal
