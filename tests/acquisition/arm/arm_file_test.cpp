#include "acquisition/arm/arm_file.h"

#include <cstring>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/arm/parameters.h"
#include "core/files/hash.h"
#include "core/random.h"
#include "core/units.h"
#include "tests/support/example_recording.h"
#include "tests/support/random_arm.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using testing::replaced;
using ::testing::StartsWith;

class ArmFileTest : public ::testing::Test {
 protected:
  Expected<ArmFile> read(std::string_view text) { return read_arm_file(folder_.write("arm.toml", text)); }
  // The message without the folder.
  std::string refusal(std::string_view text) {
    const auto arm = read(text);
    return arm ? "accepted" : arm.error().text().substr(folder_.path().string().size() + 1);
  }
  const std::string text_ = testing::ExampleRecording{}.arm;
  testing::TemporaryFolder folder_;
};

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void expect_same(const Arm& read, const Arm& written) {
  EXPECT_EQ(read.name, written.name);
  EXPECT_EQ(read.convention, written.convention);
  ASSERT_EQ(read.joints.size(), written.joints.size());
  for (std::size_t i = 0; i < read.joints.size(); ++i) {
    EXPECT_EQ(read.joints[i].sign, written.joints[i].sign);
    EXPECT_EQ(read.joints[i].has_beta, written.joints[i].has_beta);
    EXPECT_EQ(read.joints[i].mass, written.joints[i].mass);
  }
  ASSERT_EQ(read.probes.size(), written.probes.size());
  for (std::size_t i = 0; i < read.probes.size(); ++i) {
    EXPECT_EQ(read.probes[i].name, written.probes[i].name);
    EXPECT_EQ(read.probes[i].on_axis, written.probes[i].on_axis);
    EXPECT_TRUE(same_bits(read.probes[i].radius, written.probes[i].radius));
  }
  EXPECT_EQ(read.gravity_in_base, written.gravity_in_base);
  EXPECT_EQ(read.reference_temperature, written.reference_temperature);
  for (const Parameter& parameter : all_parameters(written)) {
    EXPECT_TRUE(same_bits(value(read, parameter), value(written, parameter))) << parameter.name;
  }
}

TEST_F(ArmFileTest, ReadsAnArm) {
  const auto file = read(text_);
  ASSERT_TRUE(file) << file.error().text();
  const Arm& arm = file->arm;
  EXPECT_EQ(arm.name, "two");
  EXPECT_EQ(arm.convention, Convention::Standard);
  ASSERT_EQ(arm.joints.size(), 2u);
  EXPECT_EQ(arm.joints[0].a, 100.0);
  EXPECT_EQ(arm.joints[0].d, 200.0);
  EXPECT_DOUBLE_EQ(arm.joints[0].alpha, 90.0 * units::degree);
  EXPECT_EQ(arm.joints[0].sign, 1.0);
  EXPECT_FALSE(arm.joints[0].has_beta);
  ASSERT_EQ(arm.probes.size(), 1u);
  EXPECT_EQ(arm.probes[0].tip_in_last, Eigen::Vector3d(0.0, 0.0, 50.0));
  EXPECT_TRUE(arm.probes[0].on_axis);
  EXPECT_EQ(arm.probes[0].radius, 3.0);
  EXPECT_FALSE(file->identification);
  EXPECT_EQ(file->input.sha256, sha256(text_));
}

TEST_F(ArmFileTest, ReadsSignsHayatiAnglesAndOffsetTipsInTheirUnits) {
  auto text = replaced(text_, "convention = \"standard\"", "convention = \"modified\"");
  text = replaced(text, "length = \"mm\"", "length = \"m\"");
  text = replaced(text, "alpha = 90\n", "alpha = 90\nbeta = 0.5\nsign = -1\n");
  text = replaced(text, "l = 50\n", "lx = 0.01\nly = -0.02\nlz = 0.05\n");
  const auto file = read(text);
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_EQ(file->arm.convention, Convention::Modified);
  EXPECT_EQ(file->arm.joints[0].sign, -1.0);
  EXPECT_TRUE(file->arm.joints[0].has_beta);
  EXPECT_DOUBLE_EQ(file->arm.joints[0].beta, 0.5 * units::degree);
  EXPECT_EQ(file->arm.joints[0].d, 200'000.0);
  EXPECT_LT((file->arm.probes[0].tip_in_last - Eigen::Vector3d(10.0, -20.0, 50.0)).norm(), 1e-12);
  EXPECT_FALSE(file->arm.probes[0].on_axis);
  EXPECT_EQ(file->arm.probes[0].radius, 3000.0);
}

TEST_F(ArmFileTest, NameAndSignHaveDefaults) {
  const auto file = read(replaced(text_, "name = \"two\"\n", ""));
  ASSERT_TRUE(file);
  EXPECT_EQ(file->arm.name, "arm");
}

TEST_F(ArmFileTest, WrongArmsAreRefused) {
  EXPECT_THAT(refusal(replaced(text_, "\"standard\"", "\"classic\"")),
              StartsWith("arm.toml:3:14: convention is \"classic\", expected \"standard\" or \"modified\""));
  EXPECT_THAT(refusal(replaced(text_, "d = 200", "d = \"200\"")),
              HasSubstr("`d` in [joint] is text, expected a finite"));
  EXPECT_THAT(refusal(replaced(text_, "d = 200", "d = nan")), HasSubstr("finite"));
  EXPECT_THAT(refusal(replaced(text_, "d = 200\n", "")), HasSubstr("`d` is missing in [joint]"));
  EXPECT_THAT(refusal(replaced(text_, "d = 200", "d = 200\nsign = 2")),
              HasSubstr("the sign of a joint is 2, expected"));
  EXPECT_THAT(refusal(replaced(text_, "d = 200", "d = 200\ndd = 1")), HasSubstr("arm.toml:8:1: \"dd\" is not a key"));
  EXPECT_THAT(refusal(replaced(text_, "l = 50", "l = 50\nlx = 1")), HasSubstr("not both"));
  EXPECT_THAT(refusal(replaced(text_, "l = 50", "lx = 1\nly = 2")), HasSubstr("`lz` is missing in [probe]"));
  EXPECT_THAT(refusal(replaced(text_, "radius = 3", "radius = -3")), HasSubstr("negative"));
  EXPECT_THAT(refusal(replaced(text_, "length = \"mm\", ", "")), HasSubstr("the unit `length` is not stated"));
  EXPECT_THAT(refusal(replaced(text_, "\"deg\"", "\"turns\"")), HasSubstr("\"turns\" is not a unit"));
  EXPECT_THAT(refusal(text_ + "[[probe]]\nname = \"ball\"\nl = 1\n"), HasSubstr("two probes are called \"ball\""));
  EXPECT_THAT(refusal(text_.substr(0, text_.find("[[probe]]"))), HasSubstr("the arm has no probe"));
}

TEST_F(ArmFileTest, JointsAreOneToTheMost) {
  const std::string head = text_.substr(0, text_.find("[[joint]]"));
  const std::string probe = text_.substr(text_.find("[[probe]]"));
  std::string joints;
  for (int i = 0; i < max_joints; ++i) {
    joints += "[[joint]]\na = 0\nd = 0\ntheta = 0\nalpha = 0\n";
  }
  EXPECT_EQ(refusal(head + joints + probe), "accepted");
  EXPECT_THAT(refusal(head + joints + "[[joint]]\na = 0\nd = 0\ntheta = 0\nalpha = 0\n" + probe),
              HasSubstr("the arm has 25 joints, expected 1 to 24"));
  EXPECT_THAT(refusal(head + probe), HasSubstr("the arm has 0 joints"));
}

TEST_F(ArmFileTest, EveryDigitComesBack) {
  const std::vector<std::string> names{"plain",          "",       "quote \" backslash \\", "tab\t",
                                       "µ €😀",           "\"\"\"", "# [[joint]] a = 1",     "\\u0041",
                                       "brace {} {0} %s"};
  for (std::uint64_t i = 0; i < 200; ++i) {
    RandomStream random(1, "arm_file_test", i);
    Arm arm = testing::random_arm(random);
    if (i % 3 == 0) {
      for (const Parameter& parameter : all_parameters(arm)) {
        set_value(arm, parameter, parameter.is_joint_error() ? 1e-8 * random.normal() : value(arm, parameter));
      }
      for (Joint& joint : arm.joints) {
        joint.mass = random.uniform();
      }
      arm.gravity_in_base = 9.81 * random.direction();
      arm.reference_temperature = random.uniform(18.0, 23.0);
    }
    arm.name = names[i % names.size()];
    arm.probes.back().name = names[i % names.size()] + " probe";
    std::optional<ArmIdentification> known;
    if (i % 2 == 0) {
      known.emplace();
      known->program = "artcal 0.1.0";
      known->recording = sha256("x");
      for (const Parameter& parameter : parameters_of(arm)) {
        known->parameters.push_back(parameter.name);
      }
      const auto size = static_cast<Eigen::Index>(known->parameters.size());
      const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return 1e-5 * random.normal(); });
      known->covariance = root * root.transpose();
      known->noise = 1e-3 * random.uniform();
      if (i % 4 == 0) {
        known->encoder_noise = 1e-5 * random.uniform();
        known->probing_noise = 1e-3 * random.uniform();
        for (std::uint64_t reading = 0; reading < i % 21; ++reading) {
          known->readings.push_back(fmt::format("{:012x}", 1000 * i + reading));
        }
      }
    }
    const auto file = read(arm_file_text(arm, known));
    ASSERT_TRUE(file) << file.error().text() << "\n" << arm_file_text(arm, known);
    expect_same(file->arm, arm);
    ASSERT_EQ(file->identification.has_value(), known.has_value());
    if (known) {
      EXPECT_EQ(file->identification->program, known->program);
      EXPECT_EQ(file->identification->recording, known->recording);
      EXPECT_EQ(file->identification->parameters, known->parameters);
      EXPECT_EQ(file->identification->covariance, known->covariance);
      EXPECT_EQ(file->identification->noise, known->noise);
      EXPECT_EQ(file->identification->encoder_noise, known->encoder_noise);
      EXPECT_EQ(file->identification->probing_noise, known->probing_noise);
      EXPECT_EQ(file->identification->readings, known->readings);
    }
    EXPECT_EQ(arm_file_text(file->arm, file->identification), arm_file_text(arm, known));
  }
}

TEST_F(ArmFileTest, ReadsWhatJointsDoBesideTurning) {
  // In degrees as the file, and in the field's units.
  const std::string with_masses =
      replaced(replaced(text_, "alpha = 90\n",
                        "alpha = 90\ncos_q = 0.001\nsin_2q_arcsec = -12\ngain_ppm = 40\ncoupling = 1e-5\n"
                        "compliance_arcsec_per_Nm = 10\nmass_kg = 2.5\nexpansion_per_K = 1.2e-5\n"),
               "[[probe]]", "mass_kg = 0\n[[probe]]");
  const auto arm = read(with_masses);
  ASSERT_TRUE(arm) << arm.error().text();
  const Joint& joint = arm->arm.joints[0];
  EXPECT_DOUBLE_EQ(joint.errors.cosine[0], 0.001 * units::degree);
  EXPECT_DOUBLE_EQ(joint.errors.sine[1], -12.0 * units::arcsecond);
  EXPECT_DOUBLE_EQ(joint.errors.gain, 40e-6);
  EXPECT_DOUBLE_EQ(joint.errors.coupling, 1e-5);
  EXPECT_DOUBLE_EQ(joint.errors.compliance, 10.0 * units::arcsecond / 1000.0);
  EXPECT_DOUBLE_EQ(joint.errors.expansion, 1.2e-5);
  EXPECT_EQ(joint.mass, 2.5);
  EXPECT_EQ(arm->arm.joints[1].mass, 0.0);
}

TEST_F(ArmFileTest, RefusesJointErrorsThatNoJointHas) {
  const auto with = [&](const std::string& keys) {
    return refusal(replaced(text_, "alpha = 90\n", "alpha = 90\n" + keys));
  };
  EXPECT_THAT(with("cos_q = 12\n"), HasSubstr("that is 4.32e+04 arcsec, expected at most 2063; is its unit right?"));
  EXPECT_THAT(with("gain = 40\n"), HasSubstr("expected at most 1e+05"));
  EXPECT_THAT(with("gain = 1e-5\ngain_ppm = 10\n"), HasSubstr("state either `gain` or `gain_ppm`, not both"));
  EXPECT_THAT(with("expansion_per_K = 11.5\n"), HasSubstr("ppm/K"));
  EXPECT_THAT(with("mass_kg = -1\n"), HasSubstr("the mass of a link is -1 kg"));
  EXPECT_THAT(with("compliance_arcsec_per_Nm = 10\nmass_kg = 1\n"), HasSubstr("not every joint states the mass"));
  EXPECT_THAT(with("harmonic = 1\n"), HasSubstr("harmonic"));
  const auto at_root = [&](const std::string& key) {
    return refusal(replaced(text_, "convention = ", key + "\nconvention = "));
  };
  EXPECT_THAT(at_root("gravity_m_s2 = [0, 0, -9806.65]"), HasSubstr("is no gravity"));
  EXPECT_THAT(at_root("gravity_m_s2 = [0, -9.81]"), HasSubstr("is no gravity"));
  EXPECT_THAT(at_root("reference_temperature_C = 293.15"), HasSubstr("the reference temperature is 293.15"));
}

TEST_F(ArmFileTest, RefusesNamesThatATerminalWouldObey) {
  // What is written can be parsed again whatever the name; it is the name that is refused.
  for (const char* name : {"new\nline", "\r", "\x01", "\x1f\x7f", "\u009b2J"}) {
    Arm arm = read(text_)->arm;
    arm.name = name;
    EXPECT_THAT(refusal(arm_file_text(arm, std::nullopt)), HasSubstr("another control character"));
    arm = read(text_)->arm;
    arm.probes[0].name = name;
    EXPECT_THAT(refusal(arm_file_text(arm, std::nullopt)), HasSubstr("another control character"));
  }
}

TEST_F(ArmFileTest, OddNumbersComeBackToo) {
  Arm arm = read(text_)->arm;
  for (const double odd : {-0.0, 5e-324, 2.2250738585072014e-308, 9.999999999999999e99, 1e16, 1e22,
                           123456789012345680.0, 0.1, 1.0 / 3.0, -1e-7}) {
    arm.joints[0].a = odd;
    arm.joints[1].theta = odd;
    const auto file = read(arm_file_text(arm, std::nullopt));
    ASSERT_TRUE(file) << odd << ": " << file.error().text();
    expect_same(file->arm, arm);
  }
}

// A β that is set but no parameter still bends the arm; it must not be lost on the way.
TEST_F(ArmFileTest, KeepsAHayatiAngleThatIsNoParameter) {
  Arm arm = read(text_)->arm;
  arm.joints[0].beta = 0.25;
  EXPECT_EQ(read(arm_file_text(arm, std::nullopt))->arm.joints[0].beta, 0.25);
}

TEST_F(ArmFileTest, CovarianceMustFitItsParameters) {
  const std::string head = text_ + "[identified]\nprogram = \"p\"\nrecording = \"r\"\n";
  EXPECT_EQ(refusal(head + "parameters = [\"a1\", \"l\"]\ncovariance = [[1, 0], [0, 1]]\n"), "accepted");
  EXPECT_THAT(refusal(head + "parameters = [\"a1\", \"l\"]\ncovariance = [[1, 0]]\n"), HasSubstr("not 2 rows of 2"));
  EXPECT_THAT(refusal(head + "parameters = [\"a1\", \"l\"]\ncovariance = [[1, 0], [0]]\n"),
              HasSubstr("not 2 rows of 2"));
  EXPECT_THAT(refusal(head + "parameters = [\"a9\"]\ncovariance = [[1]]\n"), HasSubstr("\"a9\" is not a parameter"));
  EXPECT_THAT(refusal(head + "parameters = [\"a1\", \"a1\"]\ncovariance = [[1, 0], [0, 1]]\n"), HasSubstr("twice"));
  EXPECT_THAT(refusal(head + "parameters = []\ncovariance = [[1]]\n"), HasSubstr("not 0 rows of 0"));
  EXPECT_THAT(refusal(head + "parameters = [\"a1\"]\ncovariance = [[inf]]\n"), HasSubstr("finite"));
  // Symmetric, no variance of zero or below, none of a combination below zero, whatever the units.
  EXPECT_EQ(refusal(head + "parameters = [\"a1\", \"theta1\"]\ncovariance = [[1, 9e-7], [9e-7, 1e-12]]\n"), "accepted");
  for (const char* none :
       {"[[1, 0.1], [0.2, 1]]", "[[1, 0], [0, 0]]", "[[1, 0], [0, -1]]", "[[1, 1.1e-6], [1.1e-6, 1e-12]]"}) {
    const std::string text = head + "parameters = [\"a1\", \"theta1\"]\ncovariance = " + none + "\n";
    EXPECT_THAT(refusal(text), HasSubstr("the covariance is none")) << none;
  }
}

}  // namespace
}  // namespace artcal
