// artcal import: a file of another program becomes a recording that can be verified.
#include <regex>

#include <gmock/gmock.h>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using testing::Ended;
using ::testing::HasSubstr;

class Import : public testing::ProgramTest {};

// The sphere plate's readings as a German spreadsheet writes them: the verdict is that of the example.
TEST_F(Import, OfATableIsVerifiedAsTheTableItself) {
  take("sphere-plate");
  std::string table = text_of("sphere-plate/readings.csv");
  table = std::regex_replace(table, std::regex(","), ";");
  table = std::regex_replace(table, std::regex("\\."), ",");
  write("export.txt", table);
  const Ended shown = run({"import", "export.txt"});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("text separated by semicolons, a header, decimal commas"));
  EXPECT_THAT(shown.out, HasSubstr("Nothing was written"));
  const Ended made = run({"import", "export.txt", "--unit", "mm", "--artefact", "sphere-plate/plate.toml",
                          "--probe-radius", "3 mm", "-o", "monday"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const auto values = [&](const std::string& recording) {
    const Ended ended =
        run({"verify", recording, "--standard", "sphere-plate", "--specification", "sphere-plate/specification.toml"});
    return ended.out.substr(ended.out.find('\n') + 1);
  };
  EXPECT_EQ(text_of("monday/readings.csv"), text_of("sphere-plate/readings.csv"));
  EXPECT_THAT(text_of("monday/recording.toml"), HasSubstr("artefacts = [\"../sphere-plate/plate.toml\"]"));
  EXPECT_THAT(values("monday/recording.toml"), HasSubstr("C4"));
}

TEST_F(Import, RefusesWhatIsMissing) {
  write("p.txt", "A;1;2;3\nB;4;5;7\n");
  const auto refusal = [&](const std::vector<std::string>& arguments, int code) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.exit_code, code) << ended.err;
    return ended.err;
  };
  EXPECT_THAT(refusal({"import", "p.txt"}, 3), HasSubstr("p.txt:1: the table has no header"));
  EXPECT_THAT(refusal({"import", "p.txt", "--columns", "name,x,y,z", "-o", "out"}, 2), HasSubstr("--unit"));
  EXPECT_THAT(refusal({"import", "p.txt", "--columns", "name,x,y,z", "--unit", "cubit", "-o", "out"}, 2),
              HasSubstr("--unit is \"cubit\""));
  EXPECT_EQ(run({"import", "p.txt", "--columns", "name,x,y,z", "--unit", "mm", "-o", "out"}).exit_code, 0);
  EXPECT_EQ(text_of("out/readings.csv"), "feature,x,y,z\nA,1,2,3\nB,4,5,7\n");
  EXPECT_THAT(refusal({"import", "p.txt", "--columns", "name,x,y,z", "--unit", "mm", "-o", "out"}, 2),
              HasSubstr("is there already"));
  EXPECT_THAT(refusal({"import", "gone.txt"}, 3), HasSubstr("gone.txt"));
}

}  // namespace
}  // namespace artcal
