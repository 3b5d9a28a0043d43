#include "artefacts/simulation/plan/plan_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/simulation/simulate.h"
#include "core/units.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::replaced;

constexpr const char* bar_text =
    "schema = \"artcal-artefact/1\"\nname = \"bar\"\nunits = { length = \"mm\" }\n"
    "[[feature]]\nname = \"A\"\nkind = \"sphere\"\ndiameter = 25\n"
    "[[feature]]\nname = \"B\"\nkind = \"sphere\"\ndiameter = 25\n"
    "[[distance]]\nbetween = [\"A\", \"B\"]\nvalue = 100\nU = 0.001\nk = 2\n";
constexpr const char* plan_text =
    "schema = \"artcal-plan/1\"\narm = \"arm.toml\"\nartefacts = [\"bar.toml\"]\nseed = 7\n"
    "units = { length = \"m\", angle = \"deg\" }\n"
    "[errors]\nlength = \"0.2 mm\"\nangle = \"1 mrad\"\nexact = [\"a2\"]\n"
    "[noise]\nencoder = \"2 arcsec\"\nprobing = \"3 um\"\ntemperature_K = 0.1\n"
    "[[joint]]\nstops = [-170, 180]\neccentricity = \"10 um\"\ngrating = \"60 mm\"\nfirst_phase = 90\n"
    "[[joint]]\nencoder = \"1 arcsec\"\ncompliance_arcsec_per_Nm = 2\nmass_kg = 1.5\n"
    "[[placement]]\nname = \"left\"\nposition = [0.3, 0.1, 0]\nturn = [0, 0, 90]\ntemperature_C = 22\n"
    "arm_temperature_C = 24\narm_temperature_end_C = 25\n"
    "[[placement]]\nname = \"any\"\nrandom = 3\nupright = true\n"
    "[[probing]]\nfeatures = [\"B\"]\npoints = 9\nrepeats = 2\ncap = 45\n"
    "[[probing]]\npattern = \"iso25\"\nplacements = [\"any\"]\n";

class PlanFileTest : public ::testing::Test {
 protected:
  Expected<PlanFile> read(const std::string& plan, const std::string& bar = bar_text) const {
    (void)testing::ExampleRecording{}.write(folder_);
    (void)folder_.write("bar.toml", bar);
    return read_plan_file(folder_.write("plan.toml", plan));
  }
  /// The refusal of the plan with one thing changed.
  std::string refusal(std::string_view from, std::string_view to) const {
    const auto file = read(replaced(plan_text, from, to));
    return file ? "not refused" : file.error().text();
  }
  testing::TemporaryFolder folder_;
};

TEST_F(PlanFileTest, SaysEverythingInTheProgramsUnits) {
  const auto file = read(plan_text);
  ASSERT_TRUE(file) << file.error().text();
  const SimulationPlan& plan = file->plan;
  EXPECT_EQ(plan.name, "plan");
  EXPECT_EQ(plan.seed, 7u);
  EXPECT_EQ(file->inputs.size(), 3u);
  EXPECT_DOUBLE_EQ(plan.errors.length, 0.2);
  EXPECT_DOUBLE_EQ(plan.errors.angle, 1e-3);
  EXPECT_THAT(plan.errors.exact, ElementsAre("a2"));
  EXPECT_DOUBLE_EQ(plan.noise.probing, 0.003);
  EXPECT_DOUBLE_EQ(plan.noise.temperature, 0.1);
  ASSERT_EQ(plan.arm.joints.size(), 2u);
  EXPECT_DOUBLE_EQ(plan.arm.joints[0].low, -170.0 * units::degree);
  EXPECT_DOUBLE_EQ(plan.arm.joints[0].eccentricity[0].amplitude, 0.010 / 30.0);
  EXPECT_DOUBLE_EQ(plan.arm.joints[0].eccentricity[0].phase, 90.0 * units::degree);
  EXPECT_DOUBLE_EQ(plan.arm.joints[0].encoder_noise, 2.0 * units::arcsecond);
  EXPECT_DOUBLE_EQ(plan.arm.joints[1].encoder_noise, 1.0 * units::arcsecond);
  EXPECT_DOUBLE_EQ(plan.arm.joints[1].compliance, 2.0 * units::arcsecond / 1000.0);
  ASSERT_EQ(plan.placements.size(), 4u);
  EXPECT_EQ(plan.placements[0].base_from_artefact->translation, Eigen::Vector3d(300.0, 100.0, 0.0));
  EXPECT_LT((plan.placements[0].base_from_artefact->rotation.col(0) - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_EQ(plan.placements[0].temperature, 22.0);
  EXPECT_EQ(plan.placements[0].temperature_end, 22.0);
  EXPECT_EQ(plan.placements[0].arm_temperature, 24.0);
  EXPECT_EQ(plan.placements[0].arm_temperature_end, 25.0);
  EXPECT_EQ(plan.placements[3].name, "any 3");
  EXPECT_TRUE(plan.placements[3].upright);
  ASSERT_EQ(plan.probings.size(), 2u);
  EXPECT_THAT(plan.probings[0].features, ElementsAre(1));
  EXPECT_THAT(plan.probings[0].placements, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(plan.probings[1].placements, ElementsAre(1, 2, 3));
  EXPECT_EQ(planned_readings(plan), 4 * 9 * 2 + 3 * 2 * 25);
}

TEST_F(PlanFileTest, DrawsJointErrorsWithTheSpreadStated) {
  (void)folder_.write("heavy.toml",
                      replaced(replaced(testing::ExampleRecording{}.arm, "d = 200", "mass_kg = 2\nd = 200"), "a = 300",
                               "mass_kg = 1\na = 300"));
  const std::string heavy = replaced(plan_text, "seed = 7", "true_arm = \"heavy.toml\"");
  const auto with = [&](const std::string& keys) { return read(replaced(heavy, "exact = [\"a2\"]", keys)); };
  const auto file = with(
      "gain_ppm = 50\ncoupling_ppm = 20\ncompliance_arcsec_per_Nm = 4\nexpansion_ppm_per_K = 1.5\nradius = \"2 um\"\n"
      "exact = [\"gain2\", \"radius\"]");
  ASSERT_TRUE(file) << file.error().text();
  const ArmErrors& errors = file->plan.errors;
  EXPECT_DOUBLE_EQ(errors.gain, 50e-6);
  EXPECT_DOUBLE_EQ(errors.coupling, 20e-6);
  EXPECT_DOUBLE_EQ(errors.compliance, 4.0 * units::arcsecond / 1000.0);
  EXPECT_DOUBLE_EQ(errors.expansion, 1.5e-6);
  EXPECT_DOUBLE_EQ(errors.radius, 0.002);
  for (const auto& [keys, why] : std::vector<std::pair<std::string, std::string>>{
           {"gain_ppm = -1", "`gain_ppm` is -1, expected a number from 0 to 10000"},
           {"gain_ppm = 20000", "expected a number from 0 to 10000"},
           {"gain_ppm = \"50 ppm\"", "gain_ppm"},
           {"gain = 5e-5", "gain"},
           {"coupling_ppm = 1e6", "from 0 to 10000"},
           {"compliance_arcsec_per_Nm = 2000", "from 0 to 1000"},
           {"expansion_ppm_per_K = 12000", "from 0 to 100"},
           {"radius = \"1 mm\"", "that of the tip \"ball\" is 3 mm, expected a tenth"},
           {"radius = 0.002", "radius"},
           {"radius = \"2 arcsec\"", "such as \"3 um\""},
           {"exact = [\"coupling1\"]", "\"coupling1\" is not a parameter"},
           {"exact = [\"cos_q1\"]", "\"cos_q1\" is not a parameter"}}) {
    const auto refused = with(keys);
    ASSERT_FALSE(refused) << keys;
    EXPECT_EQ(refused.error().code, ErrorCode::BadInput);
    EXPECT_THAT(refused.error().text(), HasSubstr(why));
  }
  EXPECT_THAT(refusal("exact = [\"a2\"]", "compliance_arcsec_per_Nm = 4"), HasSubstr("the mass of its link"));
}

TEST_F(PlanFileTest, TheStopsAreTheArmsUnlessThePlanSaysOtherwise) {
  (void)folder_.write("travel.toml",
                      replaced(replaced(testing::ExampleRecording{}.arm, "d = 200", "min = -20\nmax = 30\nd = 200"),
                               "a = 300", "max = 200\na = 300"));
  const auto file = read(replaced(plan_text, "seed = 7", "true_arm = \"travel.toml\""));
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_DOUBLE_EQ(file->plan.arm.joints[0].low, -170.0 * units::degree);  // the plan's
  EXPECT_NEAR(file->plan.arm.joints[1].low, -160.0 * units::degree, 1e-12);
  EXPECT_NEAR(file->plan.arm.joints[1].high, 200.0 * units::degree, 1e-12);
}

// An arm on a wall sags sideways; a plan that takes its file and says nothing must not put it on the floor.
TEST_F(PlanFileTest, TheArmIsMountedAsItsFileOrThePlanSays) {
  const std::string on_a_wall = "gravity_m_s2 = [9.81, 0, 0]\n";
  const auto arm_on_the_wall = [&] { return on_a_wall + testing::ExampleRecording{}.arm; };
  const auto by_plan = read(on_a_wall + plan_text);
  ASSERT_TRUE(by_plan) << by_plan.error().text();
  EXPECT_EQ(by_plan->plan.arm.arm.gravity_in_base, Eigen::Vector3d(9.81, 0.0, 0.0));
  EXPECT_EQ(by_plan->plan.nominal.gravity_in_base, Eigen::Vector3d(9.81, 0.0, 0.0));  // the recording's arm
  (void)folder_.write("wall.toml", arm_on_the_wall());
  const auto by_file = read(replaced(plan_text, "\"arm.toml\"", "\"wall.toml\""));
  ASSERT_TRUE(by_file) << by_file.error().text();
  EXPECT_EQ(by_file->plan.arm.arm.gravity_in_base, Eigen::Vector3d(9.81, 0.0, 0.0));
  EXPECT_THAT(refusal("seed = 7", "true_arm = \"wall.toml\""), HasSubstr("mounted in different ways"));
  EXPECT_TRUE(read(on_a_wall + replaced(plan_text, "seed = 7", "true_arm = \"wall.toml\"")));
  EXPECT_THAT(refusal("seed = 7", "gravity_m_s2 = [0, 0, 0]"), HasSubstr("is no gravity"));
}

TEST_F(PlanFileTest, TurnsAboutXThenYThenZ) {
  const auto file = read(replaced(plan_text, "turn = [0, 0, 90]", "turn = [90, 0, 90]"));
  // The artefact's y goes up with the first turn and stays there with the second; its z goes to -y, then to x.
  const Eigen::Matrix3d& rotation = file->plan.placements[0].base_from_artefact->rotation;
  EXPECT_LT((rotation.col(1) - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((rotation.col(2) - Eigen::Vector3d::UnitX()).norm(), 1e-12);
}

TEST_F(PlanFileTest, ZeroNoiseIsAllowedNegativeIsNot) {
  EXPECT_TRUE(read(replaced(plan_text, "\"3 um\"", "\"0 um\"")));
  EXPECT_THAT(refusal("\"3 um\"", "\"-3 um\""), AllOf(HasSubstr("plan.toml:12:"), HasSubstr("`probing` is \"-3 um\"")));
  EXPECT_THAT(refusal("\"2 arcsec\"", "\"2 um\""), HasSubstr("such as \"2 arcsec\""));
  EXPECT_THAT(refusal("temperature_K = 0.1", "temperature_K = -0.1"), HasSubstr("`temperature_K` is -0.1"));
}

TEST_F(PlanFileTest, RefusesArmsThatDoNotFit) {
  EXPECT_THAT(refusal("arm = \"arm.toml\"", "arm = \"gone.toml\""), HasSubstr("gone.toml: there is no such file"));
  (void)folder_.write("other.toml", replaced(testing::ExampleRecording{}.arm, "\"standard\"", "\"modified\""));
  EXPECT_THAT(refusal("seed = 7", "true_arm = \"other.toml\""), HasSubstr("differ in more than their numbers"));
  (void)folder_.write("other.toml", testing::ExampleRecording{}.arm + "[[probe]]\nname = \"two\"\nl = 3\n");
  EXPECT_THAT(refusal("seed = 7", "true_arm = \"other.toml\""), HasSubstr("differ in more than their numbers"));
  EXPECT_THAT(refusal("exact = [\"a2\"]", "exact = [\"a9\"]"), HasSubstr("\"a9\" is not a parameter of the arm"));
}

TEST_F(PlanFileTest, RefusesJointsThatCannotBe) {
  EXPECT_THAT(refusal("stops = [-170, 180]", "stops = [180, -170]"), HasSubstr("the end stops are 180 and -170"));
  EXPECT_THAT(refusal("stops = [-170, 180]", "stops = [10, 10]"), HasSubstr("the lower before the higher"));
  EXPECT_THAT(refusal("stops = [-170, 180]", "stops = [-1e9, 1e9]"), HasSubstr("at most 20 turns"));
  EXPECT_THAT(refusal("stops = [-170, 180]", "stops = [1]"), HasSubstr("`stops` holds 1 numbers, expected 2"));
  EXPECT_THAT(refusal("grating = \"60 mm\"\n", ""), HasSubstr("needs the diameter of the grating"));
  EXPECT_THAT(refusal("\"60 mm\"", "\"0 mm\""), HasSubstr("needs the diameter of the grating"));
  EXPECT_THAT(refusal("\"10 um\"", "\"10 mm\""), HasSubstr("encoder error of 68755 arcsec"));
  EXPECT_THAT(refusal("mass_kg = 1.5", "mass_kg = -1"), HasSubstr("`mass_kg` is -1"));
  EXPECT_THAT(refusal("[[placement]]\nname = \"left\"", "[[joint]]\n[[placement]]\nname = \"left\""),
              HasSubstr("there are 3 tables headed [[joint]]"));
}

TEST_F(PlanFileTest, RefusesNamesThatNothingHas) {
  EXPECT_THAT(refusal("features = [\"B\"]", "features = [\"C\"]"),
              HasSubstr("the artefact \"bar\" has no feature \"C\"; `features` can be \"A\""));
  EXPECT_THAT(refusal("features = [\"B\"]", "features = [\"B\", \"B\"]"), HasSubstr("\"B\" is there twice"));
  EXPECT_THAT(refusal("placements = [\"any\"]", "placements = [\"an\"]"), HasSubstr("has no placement \"an\""));
  EXPECT_THAT(refusal("\"iso25\"", "\"iso26\""), HasSubstr("the pattern is \"iso26\""));
  EXPECT_THAT(refusal("points = 9", "artefact = \"plate\""),
              HasSubstr("there is no artefact \"plate\" in this plan; `artefact` can be \"bar\""));
  EXPECT_THAT(refusal("points = 9", "probe = \"star\""), HasSubstr("the arm has no probe \"star\""));
  EXPECT_THAT(refusal("points = 9", "pints = 9"), HasSubstr("\"pints\" is not a key that is known here"));
  EXPECT_THAT(refusal("name = \"any\"", "name = \"left\\u001b[2J\""), HasSubstr("control character"));
}

TEST_F(PlanFileTest, RefusesCountsWithoutMeasure) {
  EXPECT_THAT(refusal("points = 9", "points = 0"), HasSubstr("`points` is 0, expected a whole number from 1"));
  EXPECT_THAT(refusal("points = 9", "points = 2.5"), HasSubstr("`points` is 2.5"));
  EXPECT_THAT(refusal("points = 9\nrepeats = 2", "points = 100000\nrepeats = 100000"),
              HasSubstr("the plan makes 40000000150 readings, expected at most 1000000"));
  EXPECT_THAT(refusal("random = 3", "random = 100000000000"), HasSubstr("`random` is 100000000000"));
  EXPECT_THAT(refusal("seed = 7", "seed = -1"), HasSubstr("the seed is -1"));
  EXPECT_THAT(refusal("seed = 7", "seed = 1.5"), HasSubstr("the seed is 1.5"));
  std::string idle = plan_text;
  idle.resize(idle.find("[[probing]]"));
  EXPECT_THAT(read(idle).error().text(), HasSubstr("the plan makes no readings"));
  EXPECT_THAT(refusal("points = 9", "placements = [\"any\"]"),
              HasSubstr("nothing is probed in the placement \"left\""));
}

TEST_F(PlanFileTest, RefusesPlacementsThatContradictThemselves) {
  EXPECT_THAT(refusal("random = 3", "random = 3\nposition = [0, 0, 0]"),
              HasSubstr("states its `position`, or how many"));
  EXPECT_THAT(refusal("random = 3", "position = [0, 0, 0]"), HasSubstr("`upright` is for placements that are drawn"));
  EXPECT_THAT(refusal("name = \"any\"", "name = \"any\"\nturn = [0, 0, 1]"), HasSubstr("`turn` goes with `position`"));
  EXPECT_THAT(refusal("\ntemperature_C = 22", "\ntemperature_C = 2200"), HasSubstr("`temperature_C` is 2200"));
  EXPECT_THAT(refusal("\ntemperature_C = 22", "\ntemperature_end_C = 22"), HasSubstr("needs one at the beginning"));
  EXPECT_THAT(refusal("name = \"any\"\nrandom = 3\nupright = true", "name = \"left\"\nposition = [0, 0, 0]"),
              HasSubstr("two placements are called \"left\""));
  EXPECT_THAT(refusal("cap = 45", "extent = [1, 1]"), HasSubstr("`extent` is for planes"));
  EXPECT_THAT(refusal("cap = 45", "cap = 0"), HasSubstr("more than 0 and at most 180 degrees"));
  EXPECT_THAT(refusal("cap = 45", "pole = [0, 0, 0]"), HasSubstr("`pole` is no direction"));
  const auto in_base = read(plan_text, std::string("frame = \"base\"\n") + bar_text);
  EXPECT_THAT(in_base.error().text(), HasSubstr("has no other position"));
}

TEST_F(PlanFileTest, SurvivesBeingCutShort) {
  const std::string whole = plan_text;
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    const auto file = read(whole.substr(0, size));
    EXPECT_TRUE(file || file.error().code == ErrorCode::BadInput) << size;
  }
}

}  // namespace
}  // namespace artcal
