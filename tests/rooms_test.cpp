// The rules of CONTRIBUTING.md about folders and files: rooms that one can overlook, headers and sources in pairs.

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::vector<std::string> layers{"core", "acquisition", "fitting", "artefacts", "identification", "app"};

/// Headers and sources below these folders, by the folder they are in, from the root.
std::map<std::string, std::vector<fs::path>> rooms(const fs::path& root, const std::vector<std::string>& folders) {
  std::map<std::string, std::vector<fs::path>> all;
  for (const std::string& folder : folders) {
    if (!fs::is_directory(root / folder)) {
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") {
        all[fs::relative(entry.path().parent_path(), root).generic_string()].push_back(entry.path());
      }
    }
  }
  return all;
}

std::vector<std::string> crowded(const fs::path& root, std::size_t most) {
  std::vector<std::string> folders = layers;
  folders.emplace_back("tests");
  std::vector<std::string> found;
  for (const auto& [room, files] : rooms(root, folders)) {
    if (files.size() > most) {
      found.push_back(room + ": " + std::to_string(files.size()));
    }
  }
  return found;
}

std::set<std::string> sources_without_header(const fs::path& root) {
  std::set<std::string> found;
  for (const auto& [room, files] : rooms(root, layers)) {
    for (fs::path file : files) {
      if (file.extension() == ".cpp" && !fs::exists(fs::path(file).replace_extension(".h"))) {
        found.insert(room + "/" + file.filename().string());
      }
    }
  }
  return found;
}

/// Sources that another header declares, and why.
bool is_declared_elsewhere(const std::string& source) {
  static const std::set<std::string> known{
      "app/main.cpp",                                 // nobody calls it
      "app/history/calibration_step.cpp",             // arm_history.h: the members of its steps
      "app/history/history_json.cpp",                 // arm_history.h: one value, three forms
      "app/history/parameter_drift.cpp",              // drift_sections.h: the sections of one page
      "app/history/value_drift.cpp",                  // drift_sections.h
      "app/history/verification_step.cpp",            // arm_history.h
      "app/results/fit/fit_json.cpp",                 // fit_report.h: one value, two forms
      "app/results/fit/fit_text.cpp",                 // fit_report.h
      "app/results/fit/segment_json.cpp",             // segment_result.h: one value, two forms
      "app/results/fit/segment_text.cpp",             // segment_result.h
      "app/results/planning/plan_picture.cpp",        // plan_result.h: one value, three forms
      "app/shell/completion_bash.cpp",                // completion.h: one function a shell
      "app/shell/completion_fish.cpp",                // completion.h
      "app/shell/completion_zsh.cpp",                 // completion.h
      "artefacts/constraints/build_constraints.cpp",  // constraint.h: the function that makes them
      "fitting/least_squares/axial.cpp",              // estimate.h: one function a feature, all of one kind
      "fitting/least_squares/circle.cpp",             // estimate.h: one function a feature, all of one kind
      "fitting/least_squares/plane_line.cpp",         // estimate.h: one function a feature, all of one kind
      "fitting/least_squares/sphere.cpp",             // estimate.h: one function a feature, all of one kind
  };
  // commands/command.h lists all commands, so that main() and the completion of names have one table.
  return source.starts_with("app/commands/") || known.contains(source);
}

TEST(Rooms, AreNotCrowded) { EXPECT_THAT(crowded(ARTCAL_SOURCE_DIR, 25), IsEmpty()); }

TEST(Rooms, ASourceHasAHeaderOfItsName) {
  for (const std::string& source : sources_without_header(ARTCAL_SOURCE_DIR)) {
    EXPECT_TRUE(is_declared_elsewhere(source)) << source;
  }
}

TEST(Rooms, TheCheckSeesWhatIsWrong) {
  const testing::TemporaryFolder folder;
  for (const char* name :
       {"core/a.h", "core/a.cpp", "core/text/b.cpp", "core/text/c.h", "tests/a_test.cpp", "tests/b_test.cpp"}) {
    fs::create_directories((folder.path() / name).parent_path());
    (void)folder.write(name, "");
  }
  EXPECT_THAT(crowded(folder.path(), 1), ElementsAre("core: 2", "core/text: 2", "tests: 2"));
  EXPECT_THAT(crowded(folder.path(), 2), IsEmpty());
  EXPECT_THAT(sources_without_header(folder.path()), ElementsAre("core/text/b.cpp"));
}

}  // namespace
}  // namespace artcal
