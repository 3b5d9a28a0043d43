#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace artcal::testing {

inline std::string read_all(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// How a run ended.
struct Ended {
  int exit_code = -1;  ///< -1 where a signal ended it
  int signal = 0;
  std::string out, err;
};

/// Runs the program in a folder of its own, with its own copies of the examples under examples/.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest() { std::filesystem::create_directory(folder("work")); }

  [[nodiscard]] std::filesystem::path folder(const std::string& name) const { return folder_.path() / name; }
  /// A file in the folder where the program runs.
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder("work") / name; }
  [[nodiscard]] std::string text_of(const std::string& name) const { return read_all(file(name)); }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(file(name).parent_path());
    std::ofstream(file(name), std::ios::binary) << text;
  }
  /// Copies an example, such as "ball-bar", to a folder of that name.
  void take(const std::string& example) const {
    std::filesystem::copy(std::filesystem::path(ARTCAL_SOURCE_DIR) / "examples" / example, file(example),
                          std::filesystem::copy_options::recursive);
    for (const auto& entry : std::filesystem::directory_iterator(file(example))) {
      std::filesystem::permissions(entry.path(), std::filesystem::perms::owner_write,
                                   std::filesystem::perm_options::add);
    }
  }

  /// Starts the program; its output goes to files beside the folder it runs in. No file that it writes may
  /// become larger than `most_bytes`, as if the disk were full; 0 is no limit.
  [[nodiscard]] pid_t start(const std::vector<std::string>& arguments, rlim_t max_bytes = 0) const {
    std::vector<std::string> all = arguments;
    all.insert(all.begin(), ARTCAL_PROGRAM);
    return start_command(std::move(all), max_bytes);
  }

  /// Starts any command in the same way.
  [[nodiscard]] pid_t start_command(std::vector<std::string> all, rlim_t max_bytes = 0) const {
    std::vector<char*> pointers;
    std::transform(all.begin(), all.end(), std::back_inserter(pointers), [](std::string& text) { return text.data(); });
    pointers.push_back(nullptr);
    const std::string work = folder("work").string();
    const std::string out = folder("out").string();
    const std::string err = folder("err").string();
    // A child that is killed before it empties them would leave the words of the one before.
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    const pid_t child = ::fork();
    if (child == 0) {
      if (::chdir(work.c_str()) != 0 || !redirect(out, STDOUT_FILENO) || !redirect(err, STDERR_FILENO)) {
        ::_exit(126);
      }
      if (max_bytes > 0) {
        const rlimit limit{max_bytes, max_bytes};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ::signal(SIGXFSZ, SIG_IGN);
      }
      ::execvp(pointers[0], pointers.data());
      ::_exit(127);
    }
    return child;
  }

  [[nodiscard]] Ended wait_for(pid_t child) const {
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, WIFSIGNALED(status) ? WTERMSIG(status) : 0,
            read_all(folder("out")), read_all(folder("err"))};
  }

  [[nodiscard]] Ended run(const std::vector<std::string>& arguments) const { return wait_for(start(arguments)); }

  [[nodiscard]] Ended run_command(const std::vector<std::string>& command) const {
    return wait_for(start_command(command));
  }

  /// What stands in the folder where the program runs, sorted.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder("work"))) {
      all.push_back(entry.path().filename().string());
    }
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  static bool redirect(const std::string& path, int to) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    return file >= 0 && ::dup2(file, to) == to;
  }
  TemporaryFolder folder_;
};

}  // namespace artcal::testing
