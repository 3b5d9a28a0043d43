// What the program says of itself, and that what it says works.
#include <algorithm>
#include <iterator>
#include <sstream>

#include <gmock/gmock.h>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::Not;

class Help : public testing::ProgramTest {
 protected:
  // The examples stand where the help says, seen from the folder where the program runs.
  Help() {
    std::filesystem::copy(std::filesystem::path(ARTCAL_SOURCE_DIR) / "examples", file("examples"),
                          std::filesystem::copy_options::recursive);
  }
};

TEST_F(Help, OfTheProgramNamesTheCommands) {
  const Ended ended = run({"--help"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.out, HasSubstr("identify"));
  EXPECT_THAT(ended.out, HasSubstr("coupling"));
  EXPECT_THAT(ended.out, HasSubstr("fit"));
  EXPECT_THAT(ended.err, IsEmpty());
  EXPECT_THAT(run({"--version"}).out, MatchesRegex("artcal [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  EXPECT_THAT(run({}).err, HasSubstr("--help"));
  EXPECT_THAT(run({"identfy"}).err, HasSubstr("there is no command \"identfy\""));
}

TEST_F(Help, EveryExampleOfEveryCommandRuns) {
  for (const char* command : {"fit", "segment", "identify", "coupling", "verify", "points", "simulate"}) {
    const Ended help = run({command, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.out, HasSubstr("--json"));
    EXPECT_THAT(help.out, HasSubstr("--quiet"));
    std::istringstream lines(help.out);
    int examples = 0;
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("  artcal ")) {
        continue;
      }
      for (std::string more; line.ends_with('\\') && std::getline(lines, more);) {  // as a shell joins them
        line = line.substr(0, line.size() - 1) + more;
      }
      std::istringstream words(line);
      std::vector<std::string> arguments{std::istream_iterator<std::string>(words), {}};
      arguments.erase(arguments.begin());
      if (const auto rate = std::find(arguments.begin(), arguments.end(), "--rate"); rate != arguments.end()) {
        // Two readings a second for as long as an operator takes: nobody waits for that here.
        *std::next(rate) = "1000";
      }
      const Ended ended = run(arguments);
      EXPECT_EQ(ended.exit_code, 0) << line << "\n" << ended.err;
      EXPECT_THAT(ended.out, Not(IsEmpty()));
      ++examples;
    }
    EXPECT_GT(examples, 0) << command;
  }
}

// Every example that the project brings.
TEST_F(Help, EveryRecordingUnderExamplesRuns) {
  int recordings = 0;
  for (const auto& entry : std::filesystem::directory_iterator(file("examples"))) {
    if (std::filesystem::exists(entry.path() / "recording.toml")) {
      const std::string recording = (entry.path() / "recording.toml").string();
      if (testing::read_all(entry.path() / "recording.toml").find("[[probe]]") != std::string::npos) {
        continue;  // coordinates alone: verified, not identified
      }
      EXPECT_EQ(run({"identify", recording}).exit_code, 0) << recording;
      EXPECT_EQ(run({"coupling", recording}).exit_code, 0) << recording;
      ++recordings;
    }
  }
  EXPECT_GE(recordings, 3);
}

TEST_F(Help, OutputThatIsLostIsNotDone) {
  const std::string command = std::string(ARTCAL_PROGRAM) + " identify " +
                              file("examples/gao2013/recording.toml").string() + " 2>&1 >/dev/full";
  FILE* pipe = ::popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::array<char, 200> said{};
  EXPECT_NE(std::fgets(said.data(), said.size(), pipe), nullptr);
  EXPECT_EQ(WEXITSTATUS(::pclose(pipe)), 3);
  EXPECT_THAT(said.data(), HasSubstr("standard output cannot be written"));
}

}  // namespace
}  // namespace artcal
