// Chains in and out, held against Debian's urdfdom: an independent reader with rotations as quaternions.
#include <fstream>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include "acquisition/arm/exchange/calibration_yaml.h"
#include "acquisition/arm/exchange/urdf_read.h"
#include "acquisition/arm/exchange/urdf_text.h"
#include "acquisition/arm/forward_kinematics.h"
#include "core/random.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/random_arm.h"
#include "tests/support/universal_robots.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

std::string written(const std::string& name, const std::string& text) {
  const std::string path = ::testing::TempDir() + name;
  std::ofstream(path) << text;
  return path;
}

Eigen::Isometry3d pose_of(const urdf::Pose& pose) {
  Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
  at.linear() = Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z)
                    .normalized()
                    .toRotationMatrix();
  at.translation() = 1000.0 * Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z);
  return at;
}

// The tip link's frame in the base link, mm; q in the order of the moving joints from the base.
Eigen::Isometry3d frame_by_urdfdom(const urdf::ModelInterface& model, const std::string& tip,
                                   const std::vector<double>& q) {
  std::vector<urdf::JointConstSharedPtr> joints;
  for (auto link = model.getLink(tip); link->parent_joint; link = link->getParent()) {
    joints.insert(joints.begin(), link->parent_joint);
  }
  Eigen::Isometry3d base_from_here = Eigen::Isometry3d::Identity();
  std::size_t next = 0;
  for (const auto& joint : joints) {
    base_from_here = base_from_here * pose_of(joint->parent_to_joint_origin_transform);
    const Eigen::Vector3d axis(joint->axis.x, joint->axis.y, joint->axis.z);
    if (joint->type == urdf::Joint::PRISMATIC) {
      base_from_here = base_from_here * Eigen::Translation3d(q[next++] * axis.normalized());
    } else if (joint->type != urdf::Joint::FIXED) {
      base_from_here = base_from_here * Eigen::AngleAxisd(q[next++], axis.normalized());
    }
  }
  return base_from_here;
}

Eigen::Vector3d tip_by_urdfdom(const urdf::ModelInterface& model, const std::string& tip,
                               const std::vector<double>& q) {
  return frame_by_urdfdom(model, tip, q).translation();
}

Eigen::Vector3d tip_of(const Arm& arm, const std::vector<double>& q, int probe = 0) {
  std::vector<double> sines(2 * q.size());
  joint_sines(q, sines);
  return ForwardKinematics(arm, {}, probe).tip_in_base({sines, q});
}

std::string attribute(const Eigen::Vector3d& v) {
  std::ostringstream text;
  text.precision(17);
  text << v.x() << " " << v.y() << " " << v.z();
  return text.str();
}

// A robot of six joints of any kind with fixed ones between them, the first about or along the base's z axis; some
// neighbours parallel, some axes against z.
std::string random_robot(RandomStream& random) {
  std::string text = "<robot name=\"random\"><link name=\"l0\"/>";
  for (int i = 1; i <= 8; ++i) {
    const bool fixed = i == 4 || i == 8;
    const bool slides = i == 1 || i == 5 ? random.uniform() < 0.4 : false;
    const bool parallel = i == 1 || random.uniform() < 0.3;
    const Eigen::Vector3d place = i == 1 ? Eigen::Vector3d(0.0, 0.0, 0.3) : Eigen::Vector3d(0.5 * random.direction());
    const Eigen::Vector3d turn = parallel ? Eigen::Vector3d::Zero() : Eigen::Vector3d(3.0 * random.direction());
    const Eigen::Vector3d axis =
        parallel ? Eigen::Vector3d(0.0, 0.0, random.uniform() < 0.5 ? 1.0 : -1.0) : random.direction();
    text += "<link name=\"l" + std::to_string(i) + "\"/><joint name=\"j" + std::to_string(i) + "\" type=\"" +
            (fixed    ? "fixed"
             : slides ? "prismatic"
                      : "revolute") +
            "\"><parent link=\"l" + std::to_string(i - 1) + "\"/><child link=\"l" + std::to_string(i) +
            "\"/><origin xyz=\"" + attribute(place) + "\" rpy=\"" + attribute(turn) + "\"/><axis xyz=\"" +
            attribute(axis) + "\"/><limit lower=\"-2\" upper=\"2\" effort=\"1\" velocity=\"1\"/></joint>";
  }
  return text + "</robot>";
}

TEST(Urdf, ReadChainsHaveTheirTips) {
  int slides = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomStream random(seed, "urdf");
    const std::string text = random_robot(random);
    const auto model = urdf::parseURDF(text);
    ASSERT_TRUE(model);
    const auto chain = read_urdf(written("random.urdf", text), {});
    ASSERT_TRUE(chain) << chain.error().text();
    const auto made = arm_of_chain(*chain);
    ASSERT_TRUE(made) << made.error().text();
    ASSERT_EQ(made->arm.joints.size(), 6u);
    for (int k = 0; k < 20; ++k) {
      std::vector<double> q;
      for (const Joint& joint : made->arm.joints) {
        q.push_back(random.uniform(-2.0, 2.0) * (joint.is_prismatic() ? 500.0 : 1.0));
        slides += joint.is_prismatic() ? 1 : 0;
      }
      EXPECT_LT((tip_of(made->arm, q) - tip_by_urdfdom(*model, "l8", q)).norm(), 1e-9) << seed;
    }
  }
  EXPECT_GT(slides, 100);
}

TEST(Urdf, WrittenArmsHaveTheirTips) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomStream random(seed, "urdf out");
    Arm arm = seed == 0 ? test::calibrated_ur5() : testing::random_arm(random);
    const auto text = urdf_text(arm);
    ASSERT_TRUE(text) << text.error().text();
    const auto model = urdf::parseURDF(*text);
    ASSERT_TRUE(model);
    const auto q = testing::random_joints(random, arm.joints.size());
    for (std::size_t probe = 0; probe < arm.probes.size(); ++probe) {
      const std::string link = arm.probes.size() == 1 ? "tip" : "tip_" + std::to_string(probe + 1);
      // d of hundreds of metres have a rounding of their own.
      EXPECT_LT((testing::tip_in_base(testing::ArmNumbers<double>(arm), q, static_cast<int>(probe)) -
                 tip_by_urdfdom(*model, link, q))
                    .norm(),
                seed == 0 ? 1e-6 : 1e-9)
          << seed;
    }
  }
}

TEST(Urdf, WhatCannotBeExpressedIsRefusedByJoint) {
  Arm arm = test::nominal_ur10e();
  arm.joints[2].errors.cosine[0] = 1e-4;
  EXPECT_THAT(urdf_text(arm).error().message, HasSubstr("joint 3 has cos_q3, which a URDF cannot express"));
  arm.joints[2].errors = {};
  arm.joints[2].mechanical_coupling = 1.0;
  EXPECT_THAT(urdf_text(arm).error().message, HasSubstr("joint 3 has mechanical_coupling"));
  const auto refusal = [](const std::string& joint) {
    const std::string text = "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\n" + joint + "</robot>";
    const auto chain = read_urdf(written("refused.urdf", text), {});
    return chain ? arm_of_chain(*chain).error().text() : chain.error().text();
  };
  const std::string ends = "<parent link=\"a\"/><child link=\"b\"/>";
  EXPECT_THAT(refusal("<joint name=\"loose\" type=\"floating\">" + ends + "</joint>"),
              HasSubstr("refused.urdf:2: joint \"loose\" is of the type \"floating\""));
  EXPECT_THAT(refusal("<joint name=\"finger\" type=\"revolute\">" + ends + "<mimic joint=\"x\"/></joint>"),
              HasSubstr("joint \"finger\" follows another joint"));
  EXPECT_THAT(refusal("<joint name=\"odd\" type=\"continuous\">" + ends + "<axis xyz=\"0 0 x\"/></joint>"),
              HasSubstr("joint \"odd\" has an axis that is not three numbers"));
  EXPECT_THAT(refusal("<joint name=\"tilted\" type=\"continuous\">" + ends + "<axis xyz=\"1 0 0\"/></joint>"),
              HasSubstr("the axis of joint \"tilted\" is not the z axis of the base"));
  EXPECT_THAT(refusal("<joint name=\"nowhere\" type=\"fixed\"><parent link=\"c\"/><child link=\"b\"/></joint>"),
              HasSubstr("joint \"nowhere\" names the link \"c\""));
  EXPECT_THAT(refusal("<xacro:arm_macro prefix=\"left\"/>"), HasSubstr("\"xacro:arm_macro\" is to be expanded first"));
  EXPECT_THAT(refusal("<joint name=\"still\" type=\"fixed\">" + ends + "</joint>"), HasSubstr("no joint of the chain"));
}

// Expanded files declare xacro's namespace all the same, and joints of transmissions are none of the tree.
TEST(Urdf, ExpandedFilesAreRead) {
  const auto chain = read_urdf(
      written(
          "expanded.urdf",
          "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><link name=\"a\"/><link name=\"b\"/>"
          "<joint name=\"j\" type=\"continuous\"><parent link=\"a\"/><child link=\"b\"/><axis xyz=\"0 0 1\"/></joint>"
          "<transmission name=\"t\"><joint name=\"j\"/></transmission></robot>"),
      {});
  ASSERT_TRUE(chain) << chain.error().text();
  EXPECT_EQ(chain->joints.size(), 1u);
}

// In and out again: not the tips alone but their frames are where urdfdom has those of the first file.
TEST(Urdf, TheTipsOrientationSurvives) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, "urdf frames");
    const std::string text = random_robot(random);
    const auto chain = read_urdf(written("frames.urdf", text), {});
    ASSERT_TRUE(chain) << chain.error().text();
    const auto made = arm_of_chain(*chain);
    ASSERT_TRUE(made) << made.error().text();
    const auto again = urdf_text(made->arm, made->last_from_tip);
    ASSERT_TRUE(again) << again.error().text();
    const auto before = urdf::parseURDF(text), after = urdf::parseURDF(*again);
    ASSERT_TRUE(before && after);
    for (int k = 0; k < 10; ++k) {
      std::vector<double> q;
      for (const Joint& joint : made->arm.joints) {
        q.push_back(random.uniform(-2.0, 2.0) * (joint.is_prismatic() ? 500.0 : 1.0));
      }
      const Eigen::Isometry3d one = frame_by_urdfdom(*before, "l8", q), other = frame_by_urdfdom(*after, "tip", q);
      EXPECT_LT((one.linear() - other.linear()).cwiseAbs().maxCoeff(), 1e-12) << seed;
      EXPECT_LT((one.translation() - other.translation()).norm(), 1e-9) << seed;
    }
  }
}

// With the base laid on a first axis anywhere: the same tips by that base's place.
TEST(Urdf, TheBaseMayBeLaidOnTheFirstAxis) {
  RandomStream random(5, "urdf base");
  const std::string text =
      "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><link name=\"c\"/><joint name=\"j1\" type=\"continuous\">"
      "<parent link=\"a\"/><child link=\"b\"/><origin xyz=\"1 2 3\" rpy=\"0.4 0.5 0.6\"/><axis xyz=\"0.1 0.8 "
      "0.2\"/></joint><joint name=\"j2\" type=\"continuous\"><parent link=\"b\"/><child link=\"c\"/><origin xyz=\"0.3 "
      "-0.2 0.5\"/><axis xyz=\"1 0 0\"/></joint></robot>";
  const auto chain = read_urdf(written("base.urdf", text), {});
  ASSERT_TRUE(chain);
  const auto made = arm_of_chain(*chain, true);
  ASSERT_TRUE(made);
  const auto model = urdf::parseURDF(text);
  for (int k = 0; k < 10; ++k) {
    const std::vector<double> q{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
    EXPECT_LT((made->base_from_arm * tip_of(made->arm, q) - tip_by_urdfdom(*model, "c", q)).norm(), 1e-9);
  }
}

// A kinematics file as ur_calibration writes it: the origin and the fixed-axis angles of each joint's frame in the one
// before, Tx(a) Rx(alpha) of the link before, then Tz(d) Rz(theta) of the joint's own.
std::string kinematics_file(const Arm& arm) {
  std::string text = "kinematics:\n  hash: calib_0\n";
  const char* names[] = {"shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3"};
  for (std::size_t i = 0; i < 6; ++i) {
    testing::Transform<double> at = testing::slide(2, arm.joints[i].d) * testing::turn(2, arm.joints[i].theta);
    if (i > 0) {
      at = testing::slide(0, arm.joints[i - 1].a) * testing::turn(0, arm.joints[i - 1].alpha) * at;
    }
    std::ostringstream frame;
    frame.precision(17);
    frame << "  " << names[i] << ":\n    x: " << at(0, 3) / 1000.0 << "\n    y: " << at(1, 3) / 1000.0
          << "\n    z: " << at(2, 3) / 1000.0 << "\n    roll: " << std::atan2(at(2, 1), at(2, 2))
          << "\n    pitch: " << std::atan2(-at(2, 0), std::hypot(at(0, 0), at(1, 0)))
          << "\n    yaw: " << std::atan2(at(1, 0), at(0, 0)) << "\n";
    text += frame.str();
  }
  return text;
}

Arm imported(const Arm& arm) {
  const auto chain = read_calibration_yaml(written("calibration.yaml", kinematics_file(arm)));
  EXPECT_TRUE(chain) << chain.error().text();
  const auto made = arm_of_chain(*chain);
  EXPECT_TRUE(made) << made.error().text();
  return made->arm;
}

std::vector<double> degrees(std::vector<double> q) {
  for (double& angle : q) angle *= std::numbers::pi / 180.0;
  return q;
}

// Flange positions in mm, computed from the published numbers in 50-digit arithmetic (mpmath).
TEST(CalibrationYaml, IsTheSameArm) {
  const Arm ur10e = imported(test::calibrated_ur10e());
  const auto at = [](const Arm& arm, const std::vector<double>& q, const Eigen::Vector3d& flange) {
    EXPECT_LT((tip_of(arm, degrees(q)) - flange).norm(), 1e-8);
  };
  at(ur10e, {0, 0, 0, 0, 0, 0}, {-1183.646806182, -290.32559059143, 58.972827789832});
  at(ur10e, {0, -90, 90, -90, -90, 0}, {-691.18507226318, -173.34529313203, 676.12353470234});
  at(ur10e, {30, -60, 100, -130, -90, 45}, {-660.13437434441, -582.39117591367, 227.11421581437});
  const Arm ur5 = imported(test::calibrated_ur5());
  at(ur5, {0, 0, 0, 0, 0, 0}, {-816.30461068074, -194.27553542657, -5.4645857087695});
  at(ur5, {30, -60, 100, -130, -90, 45}, {-470.51840252116, -399.98500095162, 123.02688973548});
  for (const Arm& arm : {ur10e, ur5}) {
    EXPECT_LT(std::abs(arm.joints[1].d) + std::abs(arm.joints[2].d), 1e-9);  // hundreds of metres are gone
    EXPECT_LT(reach(arm), 2000.0);
  }
  RandomStream random(9, "calibration.yaml");
  for (int k = 0; k < 50; ++k) {
    const auto q = testing::random_joints(random, 6);
    const Eigen::Vector3d flange = testing::tip_in_base(testing::ArmNumbers<double>(test::calibrated_ur10e()), q, 0);
    EXPECT_LT((tip_of(ur10e, q) - flange).norm(), 1e-6);
  }
}

TEST(CalibrationYaml, WhatIsNotThereIsNamed) {
  const auto refusal = [](const std::string& text) {
    return read_calibration_yaml(written("bad.yaml", text)).error().text();
  };
  EXPECT_THAT(refusal("kinematics:\n  shoulder: {x: 0, y: 0, z: up, roll: 0}\n"),
              HasSubstr("bad.yaml:2:29: `z` of \"shoulder\" is \"up\", expected a number"));
  std::string text = kinematics_file(test::calibrated_ur5());
  text.resize(text.find("  wrist_2"));
  EXPECT_THAT(refusal(text), HasSubstr("no frame \"wrist_2\""));
  EXPECT_THAT(refusal("joints: 3\n"), HasSubstr("no map `kinematics`"));
  EXPECT_THAT(refusal("kinematics: {\n"), HasSubstr("no YAML that can be read"));
  EXPECT_THAT(refusal(std::string(100'000, ' ') + "kinematics: 1"), HasSubstr("65536"));
}

}  // namespace
}  // namespace artcal
