#include "core/files/file_access.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class FileAccessTest : public ::testing::Test {
 protected:
  FileAccessTest() {
    fs::create_directories(path("lab/recording/scans"));
    fs::create_directories(path("lab/artefacts"));
    fs::create_directories(path("other"));
    fs::create_symlink(path("other"), path("lab/recording/link"));
  }
  [[nodiscard]] fs::path path(const char* name) const { return folder_.path() / name; }
  testing::TemporaryFolder folder_;
};

TEST_F(FileAccessTest, BesideIsTheFolderWhatIsInItAndItsSiblings) {
  const FileAccess access = FileAccess::beside(path("lab/recording/recording.toml"));
  for (const char* name : {"lab/recording/r.csv", "lab/recording/scans/s.pcd", "lab/artefacts/bar.toml", "lab/arm.toml",
                           "lab/recording/../artefacts/./bar.toml"}) {
    EXPECT_TRUE(access.allows(path(name))) << name;
  }
  for (const char* name : {"other/x.csv", "x.csv", "lab/recording/link/x.csv", "lab2/x.csv", "lab/../other/x.csv"}) {
    EXPECT_FALSE(access.allows(path(name))) << name;
  }
  EXPECT_FALSE(access.allows("/etc/passwd"));
}

TEST_F(FileAccessTest, DirectlyUnderTheRootNothingIsBeside) {
  EXPECT_FALSE(FileAccess::beside("/tmp/recording.toml").allows("/etc/passwd"));
  EXPECT_TRUE(FileAccess::beside("/tmp/recording.toml").allows("/tmp/readings.csv"));
}

TEST_F(FileAccessTest, RelativePathsAreOfTheCurrentFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(path("lab/recording"));
  EXPECT_TRUE(FileAccess::beside("recording.toml").allows("r.csv"));
  EXPECT_TRUE(FileAccess::beside("recording.toml").allows("../arm.toml"));
  EXPECT_FALSE(FileAccess::beside("recording.toml").allows("../../other/x.csv"));
  fs::current_path(before);
}

TEST_F(FileAccessTest, ResolvesOrSaysWhatToDo) {
  const FileAccess access = FileAccess::below({path("lab")});
  EXPECT_EQ(*access.resolve(path("lab/recording"), "../arm.toml", ""), path("lab/recording/../arm.toml"));
  const auto refused = access.resolve(path("lab/recording"), "../../other/x.csv", "recording.toml:3:1");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("recording.toml:3:1: the file \"../../other/x.csv\" is neither"));
  EXPECT_THAT(refused.error().text(), HasSubstr("--allow-outside"));
  EXPECT_TRUE(FileAccess::anywhere().resolve(path("lab"), "/etc/passwd", ""));
  EXPECT_LT(FileAccess::anywhere().resolve(path("lab"), std::string(300000, 'x'), "").error().text().size(), 200u);
}

}  // namespace
}  // namespace artcal
