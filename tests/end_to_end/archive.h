#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/end_to_end/program.h"

namespace artcal::testing {

/// Folders of recordings, and what `artcal batch` makes of them.
class ArchiveTest : public ProgramTest {
 protected:
  /// A copy of an example as archive/NAME, whose recording says `more` at its top.
  void file_away(const std::string& example, const std::string& name, const std::string& more) const {
    std::filesystem::create_directories(file("archive"));
    take_to(example, "archive/" + name);
    const std::string recording = "archive/" + name + "/recording.toml";
    std::string text = text_of(recording);
    if (const auto own = text.find("\ndate = "); own != std::string::npos && more.starts_with("date = ")) {
      text.erase(own, text.find('\n', own + 1) - own);
    }
    write(recording, more + text);
  }
  /// An artefact's file with another certificate, the lines of its table.
  [[nodiscard]] static std::string with_certificate(std::string text, const std::string& lines) {
    if (const auto own = text.find("[certificate]\n"); own != std::string::npos) {
      text.erase(own, text.find("\n\n", own) + 2 - own);
    }
    return text + "\n[certificate]\n" + lines;
  }
  void take_to(const std::string& example, const std::string& name) const {
    std::filesystem::copy(std::filesystem::path(ARTCAL_SOURCE_DIR) / "examples" / example, file(name),
                          std::filesystem::copy_options::recursive);
    for (const auto& entry : std::filesystem::directory_iterator(file(name))) {
      std::filesystem::permissions(entry.path(), std::filesystem::perms::owner_write,
                                   std::filesystem::perm_options::add);
    }
  }
  /// `count` identifications of ten known points each, which take no time; all of another day.
  void file_away_quick_ones(int count) const {
    for (int i = 0; i < count; ++i) {
      file_away("gao2013", fmt::format("quick-{:03}", i),
                fmt::format("date = 2026-{:02}-{:02}\n", 1 + i / 28, 1 + i % 28));
    }
  }
  [[nodiscard]] std::string dump(const std::string& store) const {
    const Ended ended = run({"store", "dump", store});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return ended.out;
  }
  [[nodiscard]] Ended batch(std::vector<std::string> more) const {
    more.insert(more.begin(), {"batch", "archive"});
    return run(more);
  }
  static void replace_in(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  }
  void change(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = text_of(name);
    replace_in(text, from, to);
    write(name, text);
  }
};

inline int count_of(const std::string& text, const std::string& what) {
  int count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace artcal::testing
