// A session with the virtual arm as the source: recorded, inspected and identified; each planted mistake is named as
// what it is, and as no other.
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using testing::Ended;
using ::testing::HasSubstr;

class VirtualSession : public testing::ProgramTest {
 protected:
  VirtualSession() {
    take("simulate");
    take("streams");
    // Four joints and few readings: the search for a mistake takes seconds, not a minute.
    write("arm.toml",
          "schema = \"artcal-arm/1\"\nname = \"four joints\"\nconvention = \"standard\"\n"
          "units = { length = \"mm\", angle = \"deg\" }\n"
          "[[joint]]\na = 20\nd = 300\ntheta = 0\nalpha = 90\n[[joint]]\na = 700\nd = 0\ntheta = 0\nalpha = 20\n"
          "[[joint]]\na = 600\nd = 60\ntheta = 0\nalpha = -80\n[[joint]]\na = 80\nd = 40\ntheta = 0\nalpha = 90\n"
          "[[probe]]\nname = \"ball 6 mm\"\nlx = 10\nly = 0\nlz = 150\nradius = 3\n");
    write("bar.toml", text_of("simulate/bar.toml"));
    write("plan.toml",
          "schema = \"artcal-plan/1\"\nname = \"session\"\narm = \"arm.toml\"\nartefacts = [\"bar.toml\"]\nseed = 1\n"
          "units = { length = \"mm\", angle = \"deg\" }\n[errors]\nlength = \"0.3 mm\"\nangle = \"0.1 deg\"\n"
          "[noise]\nencoder = \"2 arcsec\"\nprobing = \"3 um\"\n[[placement]]\nrandom = 3\n[[probing]]\npoints = 6\n");
    std::string stream = text_of("streams/simulated.toml");
    const std::string more = ", \"Angle5\", \"Angle6\"";
    write("stream.toml", stream.erase(stream.find(more), more.size()));
  }

  // What record says of a session in which these options of simulate plant a mistake.
  Ended record(const std::string& planted, const std::string& folder = "today", const std::string& arm = "arm.toml") {
    return run_command({"sh", "-c",
                        fmt::format("\"$0\" simulate plan.toml --stream {} | \"$0\" record stream.toml --arm {} "
                                    "--artefact bar.toml -o {}",
                                    planted, arm, folder),
                        ARTCAL_PROGRAM});
  }
  std::string kinds(const std::string& recording) {
    std::string all;
    const auto result = nlohmann::json::parse(run({"inspect", recording, "--json", "-"}).out);
    for (const auto& finding : result["findings"]) {
      all += (all.empty() ? "" : " ") + finding["kind"].get<std::string>();
    }
    return all;
  }
};

TEST_F(VirtualSession, WithoutAMistakeIsTheSimulationAndIsIdentified) {
  const Ended recorded = record("");
  EXPECT_EQ(recorded.exit_code, 0) << recorded.err;
  EXPECT_EQ(recorded.err, "");
  ASSERT_EQ(run({"simulate", "plan.toml", "-o", "made", "-q"}).exit_code, 0);
  std::istringstream simulated(text_of("made/readings.csv"));
  std::istringstream table(text_of("today/readings.csv"));
  std::string of_simulation;
  std::string of_recording;
  std::getline(simulated, of_simulation);
  std::getline(table, of_recording);
  EXPECT_EQ(of_recording, "artefact,placement,feature,q1,q2,q3,q4,x,y,z");
  while (std::getline(simulated, of_simulation)) {
    ASSERT_TRUE(std::getline(table, of_recording));
    EXPECT_THAT(of_recording, ::testing::StartsWith("\"ball bar 1000\"," + of_simulation + ","));
  }
  EXPECT_FALSE(std::getline(table, of_recording));
  EXPECT_EQ(kinds("today/recording.toml"), "");
  const Ended identified = run({"identify", "today/recording.toml"});
  EXPECT_EQ(identified.exit_code, 0) << identified.err;
}

TEST_F(VirtualSession, ExchangedJointsAreNamedAtTheFirstReadingsAndByInspect) {
  const Ended recorded = record("--mistake joints:2,3");
  EXPECT_EQ(recorded.exit_code, 1);
  EXPECT_THAT(recorded.err, AllOf(HasSubstr("the first 4 readings"), HasSubstr("with q2 and q3 exchanged")));
  EXPECT_EQ(kinds("today/recording.toml"), "joints_exchanged");
}

TEST_F(VirtualSession, AWrongBallIsNamedByItsDistanceAndByInspect) {
  const Ended recorded = record("--mistake wrong-feature");
  EXPECT_EQ(recorded.exit_code, 1);
  EXPECT_THAT(recorded.err, HasSubstr("certified 250.012 mm; is it another feature"));
  EXPECT_EQ(kinds("today/recording.toml"), "wrong_feature");
}

TEST_F(VirtualSession, AMovedArtefactIsNamedByInspect) {
  (void)record("--mistake moved:20");
  EXPECT_EQ(kinds("today/recording.toml"), "artefact_moved");
}

TEST_F(VirtualSession, ASlippedEncoderIsNamedByInspect) {
  (void)record("--mistake slip:3,2");
  EXPECT_EQ(kinds("today/recording.toml"), "encoder_slipped");
}

TEST_F(VirtualSession, AForgottenRadiusIsNamedByInspect) {
  std::string arm = text_of("arm.toml");
  write("pointed.toml", arm.replace(arm.find("radius = 3"), 10, "radius = 0"));
  (void)record("", "today", "pointed.toml");
  EXPECT_EQ(kinds("today/recording.toml"), "tip_radius");
}

// The arm of another seed: the plan draws other errors.
TEST_F(VirtualSession, ATableOfAnotherDayIsNamedByInspect) {
  (void)record("");
  (void)record("--seed 2", "other");
  std::string table = text_of("other/readings.csv");
  write("today/other.csv", table);
  std::string recording = text_of("today/recording.toml");
  write("today/recording.toml", recording.insert(recording.find("\"readings.csv\"") + 14, ", \"other.csv\""));
  EXPECT_EQ(kinds("today/recording.toml"), "another_arm_state");
}

TEST_F(VirtualSession, IsRefusedWhereItCannotBe) {
  EXPECT_THAT(run({"simulate", "plan.toml", "--stream", "--mistake", "joints:2,5"}).err,
              HasSubstr("--mistake is \"joints:2,5\", expected joints:2,3 or"));
  EXPECT_THAT(run({"simulate", "plan.toml", "--stream", "-o", "made"}).err, HasSubstr("nothing else"));
  EXPECT_THAT(run({"simulate", "plan.toml"}).err, HasSubstr("--output is missing"));
  EXPECT_THAT(run({"simulate", "plan.toml", "-o", "made", "--mistake", "sign:2"}).err, HasSubstr("of --stream"));
}

}  // namespace
}  // namespace artcal
