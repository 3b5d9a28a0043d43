// The table of layers (docs/architecture.md), held against every #include. The linker cannot do this: all
// folders share one include path, and a header alone links nothing.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What each folder may include beside itself. identification/ and artefacts/verification/ never meet,
/// therefore artefacts/ itself may not lead there either.
const std::map<std::string, std::set<std::string>> table{
    {"core", {}},
    {"acquisition", {"core"}},
    {"fitting", {"core"}},
    {"artefacts", {"core", "acquisition", "fitting"}},
    {"artefacts/simulation", {"core", "acquisition", "fitting", "artefacts"}},
    {"artefacts/verification", {"core", "acquisition", "fitting", "artefacts"}},
    {"identification", {"core", "acquisition", "fitting", "artefacts", "artefacts/simulation"}},
    {"app",
     {"core", "acquisition", "fitting", "artefacts", "artefacts/simulation", "artefacts/verification",
      "identification"}},
};

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

struct Include {
  int line;
  bool in_quotes;
  std::string name;
};

std::vector<Include> includes(const fs::path& path) {
  std::vector<Include> all;
  std::istringstream text(content(path));
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    std::istringstream words(line);
    char hash = 0;
    std::string word;
    words >> std::ws;
    if (!words.get(hash) || hash != '#' || !(words >> word) || !word.starts_with("include")) {
      continue;
    }
    const std::size_t open = line.find_first_of("<\"");
    const std::size_t close = open == std::string::npos ? open : line.find_first_of(">\"", open + 1);
    if (close != std::string::npos) {
      all.push_back({number, line[open] == '"', line.substr(open + 1, close - open - 1)});
    }
  }
  return all;
}

/// The layer of a path from the root, or nothing.
std::string layer_of(const std::string& path) {
  for (const char* inner : {"artefacts/simulation/", "artefacts/verification/"}) {
    if (path.starts_with(inner)) {
      return std::string(inner, std::string_view(inner).size() - 1);
    }
  }
  const std::string first = path.substr(0, path.find('/'));
  return first != path && table.contains(first) ? first : "";
}

std::vector<fs::path> sources(const fs::path& folder) {
  std::vector<fs::path> all;
  if (!fs::is_directory(folder)) {
    return all;
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".h" || extension == ".hpp" || extension == ".cpp" || extension == ".cc") {
      all.push_back(entry.path());
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<std::string> layer_violations(const fs::path& root) {
  std::vector<std::string> found;
  for (const char* folder : {"core", "acquisition", "fitting", "artefacts", "identification", "app"}) {
    for (const fs::path& path : sources(root / folder)) {
      const std::string name = fs::relative(path, root).generic_string();
      const std::string from = layer_of(name);
      for (const Include& include : includes(path)) {
        const std::string to = layer_of(include.name);
        const std::string where = name + ":" + std::to_string(include.line) + ": ";
        if (to.empty() && include.in_quotes) {
          found.push_back(where + "\"" + include.name + "\" is not named from the root of the project");
        } else if (!to.empty() && to != from && !table.at(from).contains(to)) {
          found.push_back(where + from + "/ may not include " + to + "/ (" + include.name + ")");
        }
      }
    }
  }
  return found;
}

/// The words after PUBLIC_HEADERS in a folder's CMakeLists.txt, up to the next keyword.
std::set<std::string> public_headers(const fs::path& root, const std::string& folder) {
  std::istringstream words(content(root / folder / "CMakeLists.txt"));
  std::set<std::string> headers;
  bool listed = false;
  for (std::string word; words >> word;) {
    const bool is_keyword = word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_") == std::string::npos;
    listed = is_keyword ? word == "PUBLIC_HEADERS" : listed;
    const std::size_t end = word.find(')');
    if (listed && !is_keyword) {
      headers.insert(folder + "/" + word.substr(0, end));
    }
    listed = listed && end == std::string::npos;
  }
  return headers;
}

bool may_be_shown(const Include& include, const std::set<std::string>& known) {
  if (include.in_quotes) {
    return known.contains(include.name);
  }
  const bool is_standard = include.name.find_first_of("/.") == std::string::npos;
  return is_standard || include.name.starts_with("Eigen/") || include.name == "tl/expected.hpp";
}

std::vector<std::string> header_violations(const fs::path& root) {
  std::set<std::string> known;
  for (const auto& [folder, below] : table) {
    known.merge(public_headers(root, folder));
  }
  std::vector<std::string> found;
  for (const std::string& header : known) {
    if (!fs::exists(root / header)) {
      found.push_back(header + ": is listed as a public header, but is not there");
    }
    for (const Include& include : includes(root / header)) {
      if (!may_be_shown(include, known)) {
        found.push_back(header + ":" + std::to_string(include.line) + ": a public header may not show " + include.name);
      }
    }
  }
  return found;
}

TEST(Layers, IncludesFollowTheTable) { EXPECT_THAT(layer_violations(ARTCAL_SOURCE_DIR), IsEmpty()); }

TEST(Layers, PublicHeadersShowOnlyEigenAndTheStandardLibrary) {
  EXPECT_THAT(header_violations(ARTCAL_SOURCE_DIR), IsEmpty());
}

TEST(Layers, TheCheckSeesTheProject) {
  EXPECT_GT(sources(fs::path(ARTCAL_SOURCE_DIR) / "core").size(), 10u);
  EXPECT_TRUE(public_headers(ARTCAL_SOURCE_DIR, "core").contains("core/error.h"));
  EXPECT_TRUE(public_headers(ARTCAL_SOURCE_DIR, "acquisition").contains("acquisition/arm/forward_kinematics.h"));
  EXPECT_FALSE(public_headers(ARTCAL_SOURCE_DIR, "core").contains("core/random.cpp"));
}

/// A small project with mistakes in it.
class PlantedMistakes : public ::testing::Test {
 protected:
  void plant(const std::string& name, std::string_view text) {
    fs::create_directories((folder_.path() / name).parent_path());
    (void)folder_.write(name, text);
  }
  testing::TemporaryFolder folder_;
};

TEST_F(PlantedMistakes, FoldersThatAreNotThereAreFine) {
  EXPECT_THAT(layer_violations(folder_.path()), IsEmpty());
  EXPECT_THAT(header_violations(folder_.path()), IsEmpty());
}

TEST_F(PlantedMistakes, WhatTheTableAllowsIsFine) {
  plant("core/a.h", "#pragma once\n#include <vector>\n");
  plant("fitting/b.cpp", "#include \"fitting/b.h\"\n#include \"core/a.h\"\n// #include \"app/x.h\"\n");
  plant("artefacts/verification/c.cpp", "#include \"artefacts/artefact/artefact.h\"\n#include <ceres/ceres.h>\n");
  plant("app/main.cpp", "#include \"artefacts/verification/c.h\"\n#include \"identification/i.h\"\n");
  EXPECT_THAT(layer_violations(folder_.path()), IsEmpty());
}

TEST_F(PlantedMistakes, UpwardIncludesAreFound) {
  plant("core/a.h", "#pragma once\n\n#include \"acquisition/arm/arm.h\"\n");
  plant("fitting/b.cpp", "#include \"acquisition/arm/arm.h\"\n");
  plant("identification/c.cpp", "  #  include <artefacts/verification/decision/decision.h>\n");
  plant("artefacts/d.h", "#include \"artefacts/verification/decision/decision.h\"\n");
  plant("artefacts/verification/e.h", "#include \"identification/identify.h\"\n");
  EXPECT_THAT(
      layer_violations(folder_.path()),
      ElementsAre("core/a.h:3: core/ may not include acquisition/ (acquisition/arm/arm.h)",
                  "fitting/b.cpp:1: fitting/ may not include acquisition/ (acquisition/arm/arm.h)",
                  HasSubstr("artefacts/d.h:1: artefacts/ may not include artefacts/verification/"),
                  HasSubstr("artefacts/verification/e.h:1: artefacts/verification/ may not include identif"),
                  HasSubstr("identification/c.cpp:1: identification/ may not include artefacts/verification/")));
}

TEST_F(PlantedMistakes, IncludesThatHideTheirFolderAreFound) {
  plant("core/a.cpp", "#include \"b.h\"\n#include \"../app/c.h\"\n#include \"tests/support/x.h\"\n");
  EXPECT_THAT(layer_violations(folder_.path()),
              ElementsAre(HasSubstr("core/a.cpp:1: \"b.h\" is not named from the root"), HasSubstr("a.cpp:2"),
                          HasSubstr("a.cpp:3")));
}

TEST_F(PlantedMistakes, PublicHeadersThatShowTooMuchAreFound) {
  plant("core/CMakeLists.txt", "artcal_layer(core\n  PUBLIC_HEADERS a.h\n                 gone.h\n  SOURCES b.cpp)\n");
  plant("core/a.h", "#include <vector>\n#include <Eigen/Core>\n#include <tl/expected.hpp>\n#include <fmt/format.h>\n");
  plant("fitting/CMakeLists.txt", "artcal_layer(fitting PUBLIC_HEADERS c.h)\n");
  plant("fitting/c.h", "#include \"core/a.h\"\n#include \"core/private.h\"\n#include <stdint.h>\n");
  EXPECT_THAT(header_violations(folder_.path()),
              ElementsAre("core/a.h:4: a public header may not show fmt/format.h",
                          "core/gone.h: is listed as a public header, but is not there",
                          "fitting/c.h:2: a public header may not show core/private.h",
                          "fitting/c.h:3: a public header may not show stdint.h"));
}

}  // namespace
}  // namespace artcal
