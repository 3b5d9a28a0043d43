// No command replaces a file that it reads, nor one that what it reads refers to.
#include <gmock/gmock.h>

#include "tests/end_to_end/archive.h"

namespace artcal {
namespace {

using testing::Ended;
using ::testing::HasSubstr;

class Outputs : public testing::ArchiveTest {
 protected:
  // Runs the command with each of its outputs on each of the inputs in turn.
  void expect_refused(const std::vector<std::string>& command, const std::vector<std::string>& outputs,
                      const std::vector<std::string>& inputs) const {
    for (const std::string& output : outputs) {
      for (const std::string& input : inputs) {
        const std::string before = text_of(input);
        ASSERT_FALSE(before.empty()) << input;
        std::vector<std::string> call = command;
        call.insert(call.end(), {output, input});
        const Ended ended = run(call);
        EXPECT_EQ(ended.exit_code, 2) << command[0] << " " << output << " " << input << "\n" << ended.err;
        EXPECT_THAT(ended.err, HasSubstr("overwritten"));
        EXPECT_EQ(text_of(input), before) << command[0] << " " << output << " " << input;
      }
    }
  }
  // An artefact whose certificate is a file of its own, read as a ball bar of examples/ball-bar.
  void take_certified_bar() const {
    take("certificates");
    take("ball-bar");
    write("ball-bar/certificate.xml", text_of("certificates/ball-bar-dcc-3.3.0.xml"));
    std::string bar = text_of("certificates/ball-bar-dcc-3.3.0.toml");
    replace_in(bar, "ball-bar-dcc-3.3.0.xml", "certificate.xml");
    write("ball-bar/certified.toml", bar);
  }
};

TEST_F(Outputs, OfCommandsOnARecordingSpareAllThatItRefersTo) {
  take("iso10360-12");
  const std::string recording = "iso10360-12/recording.toml";
  const std::vector<std::string> inputs{"iso10360-12/arm.toml", "iso10360-12/ball.toml",
                                        "iso10360-12/specification.toml", "iso10360-12/readings.csv", recording};
  expect_refused({"identify", recording, "-q", "--no-leave-out"}, {"--json", "-o", "--report"}, inputs);
  expect_refused({"verify", recording, "-q"}, {"--json"}, inputs);
  expect_refused({"coupling", recording, "-q"}, {"--json"}, inputs);
  expect_refused({"points", recording, "-q"}, {"--json", "-o"}, inputs);
  expect_refused({"uncertainty", recording, "--monte-carlo", "-q"}, {"--json", "--state"}, inputs);
}

TEST_F(Outputs, SpareCertificatesThatAnArtefactNames) {
  take_certified_bar();
  const std::string recording = "ball-bar/recording.toml";
  change(recording, "bar.toml", "certified.toml");
  write("ball-bar/plan.toml", "schema = \"artcal-plan/1\"\n");
  const std::vector<std::string> inputs{"ball-bar/certified.toml", "ball-bar/certificate.xml"};
  expect_refused({"points", recording, "-q"}, {"--json", "-o"}, inputs);
  expect_refused({"plan", "ball-bar/arm.toml", "--artefact", "ball-bar/certified.toml", "--encoder-noise", "2 arcsec",
                  "--probing-noise", "3 um", "-q"},
                 {"--json", "-o"}, inputs);
}

TEST_F(Outputs, OfABatchSpareAllThatItsRecordingsReferTo) {
  file_away("iso10360-12", "one", "");
  file_away("gao2013", "two", "");
  expect_refused({"batch", "archive", "--store", "s.sqlite", "-q"}, {"--json", "--report"},
                 {"archive/one/readings.csv", "archive/one/arm.toml", "archive/one/specification.toml",
                  "archive/two/coordinates.toml", "archive/two/table1.toml", "archive/two/recording.toml"});
  EXPECT_FALSE(std::filesystem::exists(file("s.sqlite"))) << "nothing has been done";
  for (int again = 0; again < 2; ++again) {
    EXPECT_LE(batch({"--store", "s.sqlite", "-q", "--json", "night.json", "--report", "night.html"}).exit_code, 1);
  }
}

TEST_F(Outputs, OfReportsSpareWhatTheResultRestsOn) {
  take("gao2013");
  ASSERT_EQ(run({"identify", "gao2013/recording.toml", "-q", "--no-leave-out", "--json", "r.json"}).exit_code, 0);
  expect_refused({"report", "r.json", "-q"}, {"-o"}, {"r.json", "gao2013/readings.csv", "gao2013/table1.toml"});
}

TEST_F(Outputs, OfAMergedMonteCarloSpareItsShards) {
  take("gao2013");
  std::string recording = text_of("gao2013/recording.toml");
  write("gao2013/recording.toml", recording + "\n[noise]\nreading = \"15 um\"\n");
  const std::vector<std::string> command{"uncertainty", "gao2013/recording.toml", "--monte-carlo", "-q"};
  std::vector<std::string> trials = command;
  trials.insert(trials.end(), {"--trials", "20", "--state", "s.json"});
  ASSERT_EQ(run(trials).exit_code, 0);
  std::vector<std::string> merged = command;
  merged.insert(merged.end(), {"--trials", "20", "--merge", "s.json"});
  expect_refused(merged, {"--json"}, {"s.json"});
}

}  // namespace
}  // namespace artcal
