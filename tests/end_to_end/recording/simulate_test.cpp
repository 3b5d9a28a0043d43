// artcal simulate: what it writes, what it leaves alone, what it refuses.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::replaced;

class Simulate : public testing::ProgramTest {
 protected:
  Simulate() { take("simulate"); }
  [[nodiscard]] std::vector<std::string> names_in(const std::string& name) const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(file(name))) {
      all.push_back(entry.path().filename().string());
    }
    std::sort(all.begin(), all.end());
    return all;
  }
  void change_plan(const std::string& from, const std::string& to) const {
    write("simulate/plan.toml", replaced(text_of("simulate/plan.toml"), from, to));
  }
};

TEST_F(Simulate, WritesARecordingThatIsIdentified) {
  const Ended ended = run({"simulate", "simulate/plan.toml", "-o", "made"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("700 simulated readings, 7 placements, seed 1"));
  EXPECT_THAT(names_in("made"),
              ElementsAre("arm.toml", "bar.toml", "readings.csv", "recording.toml", "truth-arm.toml", "truth.json"));
  EXPECT_EQ(text_of("made/arm.toml"), text_of("simulate/arm.toml"));
  EXPECT_EQ(text_of("made/bar.toml"), text_of("simulate/bar.toml"));
  EXPECT_THAT(names(), ElementsAre("made", "simulate"));  // nothing temporary stays
  const Ended identified = run({"identify", "made/recording.toml", "--no-leave-out"});
  EXPECT_EQ(identified.exit_code, 0) << identified.err;
  EXPECT_THAT(identified.out, HasSubstr("(as stated)"));
}

TEST_F(Simulate, AScanIsIdentifiedAndVerified) {
  change_plan("pattern = \"iso25\"", "scan = true\npoints = 200\ncap = 100");
  const Ended ended = run({"simulate", "simulate/plan.toml", "-o", "made"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(names_in("made"),
              ElementsAre("arm.toml", "bar.toml", "recording.toml", "scan-1.pcd", "scan-2.pcd", "scan-3.pcd",
                          "scan-4.pcd", "scan-5.pcd", "scan-6.pcd", "scan-7.pcd", "truth-arm.toml", "truth.json"));
  const Ended identified = run({"identify", "made/recording.toml", "--no-leave-out", "-o", "found.toml"});
  EXPECT_EQ(identified.exit_code, 0) << identified.err;
  const auto lengths = [&](const std::string& arm) {
    const Ended verified =
        run({"verify", "made/recording.toml", "--standard", "iso10360-12", "--arm", arm, "--json", "-"});
    EXPECT_EQ(verified.exit_code, 1) << verified.err;  // no plan
    double worst = 0.0;
    int count = 0;
    const auto result = nlohmann::json::parse(verified.out);
    for (const auto& value : result["values"]) {
      worst = std::max(worst, std::abs(value["value_mm"].get<double>()));
      ++count;
    }
    EXPECT_GT(count, 0);
    return worst;
  };
  EXPECT_GT(lengths("made/arm.toml"), 0.3);
  EXPECT_LT(lengths("made/truth-arm.toml"), 0.06);
  EXPECT_LT(lengths("found.toml"), 0.06);
  EXPECT_EQ(run({"simulate", "simulate/plan.toml", "-o", "made", "--force", "-q"}).exit_code, 0);
}

TEST_F(Simulate, TheSameSeedGivesTheSameBytes) {
  for (const auto& [folder, seed, threads] :
       {std::tuple("one", "1", "1"), std::tuple("two", "1", "5"), std::tuple("three", "2", "1")}) {
    ASSERT_EQ(
        run({"simulate", "simulate/plan.toml", "-o", folder, "--seed", seed, "--threads", threads, "-q"}).exit_code, 0);
  }
  for (const auto& name : names_in("one")) {
    EXPECT_EQ(text_of("one/" + name), text_of("two/" + name)) << name;
  }
  EXPECT_NE(text_of("one/readings.csv"), text_of("three/readings.csv"));
  EXPECT_NE(text_of("one/truth-arm.toml"), text_of("three/truth-arm.toml"));
}

TEST_F(Simulate, ReplacesOnlyWhatIsItsOwn) {
  ASSERT_EQ(run({"simulate", "simulate/plan.toml", "-o", "made", "-q"}).exit_code, 0);
  const std::string before = text_of("made/readings.csv");
  const Ended again = run({"simulate", "simulate/plan.toml", "-o", "made", "--seed", "2"});
  EXPECT_EQ(again.exit_code, 3);
  EXPECT_THAT(again.err, HasSubstr("made: the folder is there already; name another one, or add --force"));
  EXPECT_EQ(text_of("made/readings.csv"), before);
  EXPECT_EQ(run({"simulate", "simulate/plan.toml", "-o", "made/", "--seed", "2", "--force"}).exit_code, 0);
  EXPECT_NE(text_of("made/readings.csv"), before);
  write("made/thesis.txt", "years of work");
  const Ended foreign = run({"simulate", "simulate/plan.toml", "-o", "made", "--force"});
  EXPECT_EQ(foreign.exit_code, 3);
  EXPECT_THAT(foreign.err, HasSubstr("the folder holds \"thesis.txt\""));
  EXPECT_EQ(text_of("made/thesis.txt"), "years of work");
  write("note", "a file");
  EXPECT_THAT(run({"simulate", "simulate/plan.toml", "-o", "note", "--force"}).err, HasSubstr("no folder"));
  EXPECT_THAT(names(), ElementsAre("made", "note", "simulate"));
}

TEST_F(Simulate, MissesTheFolderToWriteInBeforeItWorks) {
  change_plan("random = 7", "position = [5000, 0, 0]");
  const Ended ended = run({"simulate", "simulate/plan.toml", "-o", "not/there"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("not/there: there is no folder"));
  EXPECT_THAT(ended.err, Not(HasSubstr("does not reach")));
  EXPECT_THAT(names(), ElementsAre("simulate"));
}

TEST_F(Simulate, DoesNotOverwriteItsOwnPlan) {
  write("here/arm.toml", text_of("simulate/arm.toml"));
  write("here/bar.toml", text_of("simulate/bar.toml"));
  write("plan.toml", replaced(replaced(text_of("simulate/plan.toml"), "\"arm.toml\"", "\"here/arm.toml\""),
                              "\"bar.toml\"", "\"here/bar.toml\""));
  const Ended ended = run({"simulate", "plan.toml", "-o", "here", "--force"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, HasSubstr("is an input of this result"));
  EXPECT_THAT(names_in("here"), ElementsAre("arm.toml", "bar.toml"));
}

TEST_F(Simulate, LeavesNothingWhereItFails) {
  change_plan("random = 7", "position = [5000, 0, 0]");
  const Ended ended = run({"simulate", "simulate/plan.toml", "-o", "made"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("simulate/plan.toml:2"));
  EXPECT_THAT(ended.err, HasSubstr("the arm does not reach point 1 of the feature \"0\""));
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_THAT(names(), ElementsAre("simulate"));
  EXPECT_THAT(run({"simulate", "simulate/plan.toml"}).exit_code, 2);
  EXPECT_THAT(run({"simulate", "gone.toml", "-o", "made"}).err, HasSubstr("gone.toml: there is no such file"));
}

TEST_F(Simulate, AFullDiskLeavesNoHalfFolder) {
  const Ended ended = wait_for(start({"simulate", "simulate/plan.toml", "-o", "made"}, 4096));
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("cannot be written"));
  EXPECT_THAT(names(), ElementsAre("simulate"));
}

TEST_F(Simulate, FilesOfOneNameAreRefused) {
  std::filesystem::copy(file("simulate/bar.toml"), file("simulate/readings.csv"));
  change_plan("artefacts = [\"bar.toml\"]", "artefacts = [\"readings.csv\"]");
  const Ended ended = run({"simulate", "simulate/plan.toml", "-o", "made"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("is called \"readings.csv\", as another file of the recording will be"));
}

TEST_F(Simulate, NamesThatWouldDisturbTheFilesAreKept) {
  change_plan("random = 7", "name = 'left, \"upper\" \\'\nrandom = 2");
  ASSERT_EQ(run({"simulate", "simulate/plan.toml", "-o", "made", "-q"}).exit_code, 0);
  const Ended ended = run({"coupling", "made/recording.toml"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

}  // namespace
}  // namespace artcal
