// Whatever the answers, the program's own readers take what `artcal new` writes.
#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/arm/arm_file.h"
#include "app/templates/arm_template.h"
#include "app/templates/artefact_template.h"
#include "app/templates/plan_template.h"
#include "app/templates/recording_template.h"
#include "artefacts/artefact/artefact_file.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

class Templates : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
};

TEST_F(Templates, AnArmOfAnyAnswersIsRead) {
  for (const char* joints : {"1", "2", "3", "6", "7", "24"}) {
    for (const char* convention : {"standard", "modified"}) {
      for (const auto& [length, angle] : std::vector<std::pair<std::string, std::string>>{
               {"mm", "deg"}, {"m", "rad"}, {"in", "mrad"}, {"um", "arcsec"}}) {
        ArmTemplate arm{"arm \"7\" \\ ü", joints, convention, length, angle, "0.125 in"};
        ASSERT_TRUE(check_choices(arm.choices()));
        const auto file = read_arm_file(folder_.write("arm.toml", arm.text()));
        ASSERT_TRUE(file) << file.error().text();
        EXPECT_EQ(file->arm.name, "arm \"7\" \\ ü");
        EXPECT_EQ(file->arm.joints.size(), std::stoul(joints));
        EXPECT_NEAR(file->arm.joints.back().alpha,
                    convention == std::string("modified") && joints == std::string("1") ? 0.0 : 1.5707963267948966,
                    1e-12);
        EXPECT_NEAR(file->arm.probes.front().tip_in_last.z(), 183.5, 1e-9);
        EXPECT_NEAR(file->arm.probes.front().radius, 3.175, 1e-12);
      }
    }
  }
}

TEST_F(Templates, AnArtefactOfAnyTypeIsRead) {
  ArtefactTemplate any;
  const auto choices = any.choices();
  const auto types = std::find_if(choices.begin(), choices.end(), [](const Choice& c) { return c.option == "--type"; });
  ASSERT_EQ(types->among.size(), 8u);
  for (const std::string& type : types->among) {
    for (const char* unit : {"mm", "in", "m", "um"}) {
      ArtefactTemplate made{"plate", type, "default", unit};
      ASSERT_TRUE(check_choices(made.choices()));
      const auto text = made.text();
      ASSERT_TRUE(text) << text.error().text();
      const auto file = read_artefact_file(folder_.write("artefact.toml", *text));
      ASSERT_TRUE(file) << type << file.error().text();
    }
  }
  EXPECT_TRUE(read_artefact_file(folder_.write("bar.toml", *ArtefactTemplate{"bar", "ball-bar", "17", "mm"}.text())));
  EXPECT_TRUE(
      read_artefact_file(folder_.write("p.toml", *ArtefactTemplate{"plate", "sphere-plate", "30", "mm"}.text())));
  EXPECT_THAT((ArtefactTemplate{"ball", "sphere", "2", "mm"}.text().error().text()), HasSubstr("a sphere has 1"));
  EXPECT_THAT((ArtefactTemplate{"bar", "ball-bar", "1", "mm"}.text().error().text()), HasSubstr("has 2 to 100 here"));
}

TEST_F(Templates, WrongAnswersAreRefused) {
  ArmTemplate arm;
  arm.joints = "25";
  EXPECT_THAT(check_choices(arm.choices()).error().text(),
              HasSubstr("--joints is \"25\", expected a number from 1 to 24"));
  arm = {};
  arm.tip_radius = "3";
  EXPECT_THAT(check_choices(arm.choices()).error().text(), HasSubstr("--tip-radius is \"3\""));
  arm = {};
  arm.name = "a\nb";
  EXPECT_THAT(check_choices(arm.choices()).error().text(), HasSubstr("--name"));
  PlanTemplate plan;
  plan.encoder_noise = "2";
  EXPECT_THAT(check_choices(plan.choices()).error().text(), HasSubstr("--encoder-noise is \"2\""));
  RecordingTemplate recording;
  recording.probing_noise = "0 um";
  EXPECT_THAT(check_choices(recording.choices()).error().text(), HasSubstr("--probing-noise is \"0 um\""));
  recording.probing_noise = "3 um";
  EXPECT_THAT(recording.text(".").error().text(), HasSubstr("expected both or neither"));
  recording.encoder_noise = "2 arcsec";
  EXPECT_TRUE(recording.text("."));
  recording.readings_are = "coordinates";
  EXPECT_THAT(recording.text(".").error().text(), HasSubstr("--encoder-noise is for joint angles"));
}

TEST_F(Templates, QuestionsTakeDefaultsAndAskAgain) {
  ArmTemplate arm;
  std::istringstream answers("my own\n\n seven \n7\nmodfied\nmodified\n\n\n\n");
  std::ostringstream asked;
  // An empty answer is the default; "seven", "7" and "modfied" are no convention.
  ASSERT_TRUE(ask(arm.choices(), answers, asked)) << asked.str();
  EXPECT_EQ(arm.name, "my own");
  EXPECT_EQ(arm.joints, "6");
  EXPECT_EQ(arm.convention, "modified");
  EXPECT_THAT(asked.str(), HasSubstr("number of joints [6]: "));
  EXPECT_THAT(asked.str(), HasSubstr("convention of the parameters (standard, modified) [standard]: "));
  EXPECT_THAT(asked.str(), HasSubstr("\"modfied\" is not one of standard, modified"));
  std::istringstream too_few("a\n");
  EXPECT_THAT(ask(arm.choices(), too_few, asked).error().text(), HasSubstr("nothing was written"));
}

}  // namespace
}  // namespace artcal
