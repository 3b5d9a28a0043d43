#include "app/batch/run_recording.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/batch/recording_key.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class RunRecording : public ::testing::Test {
 protected:
  RunRecording() {
    fs::copy(fs::path(ARTCAL_SOURCE_DIR) / "examples/gao2013", path("here"), fs::copy_options::recursive);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  testing::TemporaryFolder folder_;
};

std::string key_of(const RecordingOutcome& outcome) {
  return std::get<std::string>(outcome.entry[StoreTable::Recordings].at(0).at(0));
}

TEST_F(RunRecording, AResultDoesNotDependOnWhereItLies) {
  fs::copy(path("here"), path("there"));
  const auto here = run_recording(path("here/recording.toml"), {}, {});
  const auto there = run_recording(path("there/recording.toml"), {}, {});
  EXPECT_EQ(here.exit_code, 0) << here.error;
  for (std::size_t i = 0; i < store_table_count; ++i) {
    if (i != static_cast<std::size_t>(StoreTable::Files)) {
      EXPECT_EQ(here.entry.tables[i], there.entry.tables[i]) << shape_of(static_cast<StoreTable>(i)).name;
    }
  }
  EXPECT_NE(key_of(here), key_of(run_recording(path("here/recording.toml"), {true}, {}))) << "other options";
}

TEST_F(RunRecording, ItsNameIsOfItsContentWhateverItsFileIsCalled) {
  const std::string before = key_of(run_recording(path("here/recording.toml"), {}, {}));
  fs::rename(path("here/recording.toml"), path("here/monday-recording.toml"));
  EXPECT_EQ(key_of(run_recording(path("here/monday-recording.toml"), {}, {})), before);
}

TEST_F(RunRecording, WhatIsNotThereIsNothingToStore) {
  const auto outcome = run_recording(path("here/mistyped.toml"), {}, {});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_TRUE(outcome.entry[StoreTable::Files].empty());
}

TEST(WithoutFolder, OnlyWherePathsBegin) {
  EXPECT_EQ(without_folder("/a/r.csv:3: no; see /a/arm.toml", "/a"), "r.csv:3: no; see arm.toml");
  EXPECT_EQ(without_folder("\"/a/r.csv\" (/a/x)", "/a"), "\"r.csv\" (x)");
  EXPECT_EQ(without_folder("/data/a/r.csv: no", "/a"), "/data/a/r.csv: no");
  EXPECT_EQ(without_folder("mm/a/b", "/a"), "mm/a/b");
  EXPECT_EQ(without_folder("/etc/passwd", "/"), "/etc/passwd");
}

TEST_F(RunRecording, EveryInputIsPartOfItsName) {
  const std::string before = key_of(run_recording(path("here/recording.toml"), {}, {}));
  for (const char* name : {"recording.toml", "table1.toml", "readings.csv", "coordinates.toml"}) {
    const auto size = fs::file_size(path(std::string("here/") + name));
    std::ofstream(path(std::string("here/") + name), std::ios::app) << "\n";
    EXPECT_NE(key_of(run_recording(path("here/recording.toml"), {}, {})), before) << name;
    fs::resize_file(path(std::string("here/") + name), size);
  }
  EXPECT_EQ(key_of(run_recording(path("here/recording.toml"), {}, {})), before);
}

TEST_F(RunRecording, AFileThatChangesMeanwhileIsNotJudged) {
  // The store is asked after everything was read and before anything is computed: that is when another program writes.
  const FindResult meanwhile = [&](const std::string&) -> std::optional<StoredResult> {
    std::ofstream(path("here/readings.csv"), std::ios::app) << "\n";
    return std::nullopt;
  };
  const auto outcome = run_recording(path("here/recording.toml"), {}, meanwhile);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.error, HasSubstr("readings.csv: the file changed while the recording was being processed"));
  EXPECT_TRUE(outcome.entry[StoreTable::Recordings].empty());
  EXPECT_EQ(outcome.entry[StoreTable::Files].size(), 1u);
}

TEST_F(RunRecording, WhatIsKnownIsNotComputed) {
  const auto first = run_recording(path("here/recording.toml"), {}, {});
  const auto again = run_recording(path("here/recording.toml"), {}, [&](const std::string& key) {
    EXPECT_EQ(key, key_of(first));
    return std::optional(StoredResult{4, "no answer"});
  });
  EXPECT_TRUE(again.was_known);
  EXPECT_EQ(again.exit_code, 4);
  EXPECT_EQ(again.error, "no answer");
  EXPECT_TRUE(again.entry[StoreTable::Identifications].empty());
}

TEST_F(RunRecording, ErrorsNameFilesFromTheRecordingsFolder) {
  fs::remove(path("here/table1.toml"));
  const auto outcome = run_recording(path("here/recording.toml"), {}, {});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.error, ::testing::StartsWith("table1.toml"));
}

}  // namespace
}  // namespace artcal
