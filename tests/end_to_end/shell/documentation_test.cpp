// The files that docs/files.md shows are files that the program reads.
#include <sstream>

#include <gmock/gmock.h>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

// The indented blocks of a Markdown text.
std::vector<std::string> blocks_of(const std::string& markdown) {
  std::istringstream lines(markdown);
  std::vector<std::string> blocks{""};
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("    ")) {
      blocks.back() += line.substr(4) + "\n";
    } else if (line.empty() && !blocks.back().empty()) {
      blocks.back() += "\n";
    } else if (!blocks.back().empty()) {
      blocks.emplace_back();
    }
  }
  return blocks;
}

class Documentation : public testing::ProgramTest {};

TEST_F(Documentation, TheFilesItShowsMakeARecording) {
  int files = 0;
  for (const std::string& block : blocks_of(testing::read_all(std::string(ARTCAL_SOURCE_DIR) + "/docs/files.md"))) {
    for (const auto& [begin, name] :
         {std::pair("schema = \"artcal-arm/1\"", "arm.toml"), std::pair("schema = \"artcal-artefact/1\"", "bar.toml"),
          std::pair("schema = \"artcal-recording/1\"", "recording.toml"), std::pair("placement,feature", "monday.csv"),
          std::pair("placement,feature", "tuesday.csv"), std::pair("schema = \"artcal-plan/1\"", "plan.toml")}) {
      if (block.starts_with(begin)) {
        write(name, block);
        ++files;
      }
    }
  }
  EXPECT_EQ(files, 6);
  // Four readings are far too few, which is found only after every file has been understood.
  const testing::Ended ended = run({"identify", "recording.toml"});
  EXPECT_EQ(ended.exit_code, 4) << ended.err;
  // So has the plan, before it is seen that two joints reach no bar of a metre.
  EXPECT_THAT(run({"simulate", "plan.toml", "-o", "made"}).err, ::testing::HasSubstr("the arm does not reach point"));
}

}  // namespace
}  // namespace artcal
