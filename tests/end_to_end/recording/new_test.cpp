// artcal new: what it writes runs with the numbers that it has.
#include <gmock/gmock.h>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class New : public testing::ProgramTest {
 protected:
  std::string made(const std::vector<std::string>& arguments) const {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.exit_code, 0) << arguments[1] << ": " << ended.err;
    return ended.out;
  }
};

TEST_F(New, AnArmAnArtefactAndAPlanAreSimulatedAndIdentified) {
  EXPECT_THAT(made({"new", "plan", "-o", "plan.toml"}),
              AllOf(HasSubstr("The plan is in plan.toml."), HasSubstr("Not there yet: arm.toml, artefact.toml.")));
  made({"new", "arm", "-o", "arm.toml"});
  made({"new", "artefact", "-o", "artefact.toml"});
  made({"simulate", "plan.toml", "-o", "simulated", "-q"});
  // A recording of our own for the readings that were simulated, one folder up.
  EXPECT_THAT(made({"new", "recording", "--readings", "simulated/readings.csv", "--encoder-noise", "2 arcsec",
                    "--probing-noise", "3 um", "-o", "recording.toml"}),
              ::testing::Not(HasSubstr("Not there yet")));
  const auto result = [&](const std::string& recording) {
    const std::string text = made({"identify", recording, "--no-leave-out"});
    return text.substr(text.find('\n'));
  };
  EXPECT_EQ(result("recording.toml"), result("simulated/recording.toml"));
}

TEST_F(New, ARobotInTheOtherConventionRunsToo) {
  made({"new", "arm", "--convention", "modified", "--joints", "7", "--length-unit", "in", "--angle-unit", "rad", "-o",
        "arm.toml"});
  made({"new", "artefact", "--type", "sphere-plate", "--length-unit", "in", "-o", "artefact.toml"});
  made({"new", "plan", "--placements", "5", "--points", "20", "-o", "plan.toml"});
  made({"simulate", "plan.toml", "-o", "simulated", "-q"});
  made({"identify", "simulated/recording.toml", "--no-leave-out"});
}

TEST_F(New, ArtefactsOfAllTypesAreSimulated) {
  made({"new", "arm", "-o", "arm.toml"});
  std::filesystem::create_directory(file("plans"));
  for (const char* type :
       {"ball-bar", "sphere-plate", "sphere", "plane", "seat-plate", "step-gauge", "gauge-block", "telescoping-bar"}) {
    const std::string name = std::string(type) + ".toml";
    made({"new", "artefact", "--type", type, "-o", name});
    made({"new", "plan", "--artefact", name, "--placements", "2", "-o", "plans/" + name});
    made({"simulate", "plans/" + name, "-o", std::string("of ") + type, "-q"});
  }
}

TEST_F(New, ARecordingOfCoordinatesIsVerified) {
  take("sphere-plate");
  made({"new", "recording", "--readings-are", "coordinates", "--artefact", "sphere-plate/plate.toml", "--readings",
        "sphere-plate/readings.csv", "--standard", "sphere-plate", "-o", "recording.toml"});
  const Ended ours = run({"verify", "recording.toml", "--specification", "sphere-plate/specification.toml"});
  const Ended example = run({"verify", "sphere-plate/recording.toml"});
  EXPECT_EQ(ours.exit_code, example.exit_code) << ours.err;
  EXPECT_THAT(ours.out, HasSubstr("C4"));
}

TEST_F(New, PrintsWithoutAFileAndOverwritesNone) {
  EXPECT_THAT(made({"new", "arm", "--joints", "3"}), HasSubstr("schema = \"artcal-arm/1\""));
  made({"new", "arm", "-q", "-o", "arm.toml"});
  const Ended again = run({"new", "arm", "-o", "arm.toml"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.err, HasSubstr("arm.toml is there already"));
  const Ended wrong = run({"new", "arm", "--joints", "0", "-o", "other.toml"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--joints is \"0\", expected"));
  EXPECT_THAT(wrong.out, IsEmpty());
  EXPECT_EQ(run({"new"}).exit_code, 2);
  EXPECT_EQ(run({"new", "robot"}).exit_code, 2);
}

}  // namespace
}  // namespace artcal
