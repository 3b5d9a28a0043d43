#include "acquisition/arm/parameters.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/support/random_arm.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> names(const Arm& arm) {
  std::vector<std::string> all;
  for (const Parameter& parameter : parameters_of(arm)) {
    all.push_back(parameter.name);
  }
  return all;
}

Arm two_joints() {
  Arm arm;
  arm.joints.resize(2);
  arm.probes.resize(1);
  return arm;
}

TEST(Parameters, NamesAsTheFieldWritesThem) {
  Arm arm = two_joints();
  EXPECT_THAT(names(arm),
              ElementsAre("a1", "a2", "d1", "d2", "theta1", "theta2", "alpha1", "alpha2", "lx", "ly", "lz"));
  arm.probes[0].on_axis = true;
  EXPECT_THAT(names(arm), ElementsAre("a1", "a2", "d1", "d2", "theta1", "theta2", "alpha1", "alpha2", "l"));
}

TEST(Parameters, InModifiedDhAAndAlphaCarryTheLinkBefore) {
  Arm arm = two_joints();
  arm.convention = Convention::Modified;
  arm.probes[0].on_axis = true;
  arm.joints[1].has_beta = true;
  EXPECT_THAT(names(arm), ElementsAre("a0", "a1", "d1", "d2", "theta1", "theta2", "alpha0", "alpha1", "beta1", "l"));
}

TEST(Parameters, SeveralProbesAreToldApart) {
  Arm arm = two_joints();
  arm.joints[0].has_beta = true;
  arm.probes.resize(2);
  arm.probes[0] = {"ball", Eigen::Vector3d::Zero(), 0.0, true};
  arm.probes[1].name = "star";
  EXPECT_THAT(names(arm), ElementsAre("a1", "a2", "d1", "d2", "theta1", "theta2", "alpha1", "alpha2", "beta1", "l:ball",
                                      "lx:star", "ly:star", "lz:star"));
}

TEST(Parameters, EveryOneHasItsOwnPlace) {
  for (int i = 0; i < 100; ++i) {
    RandomStream random(1, "parameters", static_cast<std::uint64_t>(i));
    Arm arm = testing::random_arm(random);
    const auto all = parameters_with_radii(arm);
    std::set<std::string> seen;
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_TRUE(seen.insert(all[k].name).second) << all[k].name;
      EXPECT_EQ(find_parameter(all, all[k].name), static_cast<int>(k));
      set_value(arm, all[k], 1000.0 + static_cast<double>(k));
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_EQ(value(arm, all[k]), 1000.0 + static_cast<double>(k)) << all[k].name;
    }
    EXPECT_EQ(find_parameter(all, "a99"), -1);
  }
}

TEST(Parameters, ValuesAreThoseOfTheArm) {
  Arm arm = two_joints();
  arm.joints[1] = {1.0, 2.0, 3.0, 4.0, 5.0, 1.0, true};
  arm.probes[0].tip_in_last = {6.0, 7.0, 8.0};
  const auto all = parameters_of(arm);
  const auto at = [&](std::string_view name) {
    return value(arm, all[static_cast<std::size_t>(find_parameter(all, name))]);
  };
  EXPECT_EQ(at("a2"), 1.0);
  EXPECT_EQ(at("d2"), 2.0);
  EXPECT_EQ(at("theta2"), 3.0);
  EXPECT_EQ(at("alpha2"), 4.0);
  EXPECT_EQ(at("beta2"), 5.0);
  EXPECT_EQ(at("lx"), 6.0);
  EXPECT_EQ(at("ly"), 7.0);
  EXPECT_EQ(at("lz"), 8.0);
}

TEST(Parameters, ARadiusIsOneOnlyWhereItIsAskedFor) {
  Arm arm = two_joints();
  arm.probes[0].radius = 3.0;
  EXPECT_EQ(find_parameter(parameters_of(arm), "radius"), -1);
  auto all = parameters_with_radii(arm);
  ASSERT_EQ(all.size(), parameters_of(arm).size() + 1);
  EXPECT_EQ(all.back().name, "radius");
  EXPECT_EQ(all.back().unit(), "mm");
  EXPECT_FALSE(all.back().is_tip());
  EXPECT_EQ(value(arm, all.back()), 3.0);
  arm.probes.push_back({"star", Eigen::Vector3d::Zero(), 2.0, true});
  all = parameters_with_radii(arm);
  EXPECT_EQ(all.back().name, "radius:star");
  EXPECT_EQ(value(arm, all.back()), 2.0);
}

TEST(Parameters, UnitsAndScales) {
  const Parameter length{"a1", ParameterKind::A, 0};
  const Parameter angle{"beta1", ParameterKind::Beta, 0};
  EXPECT_EQ(length.unit(), "mm");
  EXPECT_EQ(angle.unit(), "rad");
  EXPECT_EQ(physical_scale(length, 2000.0), 1.0);
  EXPECT_EQ(physical_scale(angle, 2000.0), 1.0 / 2000.0);
  EXPECT_TRUE((Parameter{"lz", ParameterKind::TipZ, 0}.is_tip()));
  EXPECT_FALSE(length.is_tip());
  EXPECT_FALSE((Parameter{"lz", ParameterKind::TipZ, 0}.is_angle()));
}

}  // namespace
}  // namespace artcal
