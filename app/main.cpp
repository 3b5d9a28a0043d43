// artcal. The table of commands is app/commands/command_table.cpp. Exit codes: 0 done, 1 done and a verification
// failed, 2 wrong usage, 3 bad input, 4 no solution.
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>

#include <fmt/format.h>
#include <glog/logging.h>

#include "app/output/phrases.h"
#include "app/shell/program.h"
#include "app/store/where.h"

namespace {

constexpr int bad_input = 3;

int not_all_said() {
  fmt::print(stderr, "artcal: standard output cannot be written\n");
  return bad_input;
}

// A full disk or a closed pipe shows only when the last of the output is flushed.
int said_all(int exit_code) {
  std::cout.flush();  // the parser prints help there
  return std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? exit_code : not_all_said();
}

}  // namespace

int main(int argc, char** argv) {
  // Beyond the largest file allowed (ulimit -f), writing is an error like any other, told and cleaned up after.
  ::signal(SIGXFSZ, SIG_IGN);
  // Ceres logs matrices where numbers break down; what a person needs to know of it is in the error's sentence.
  FLAGS_minloglevel = google::GLOG_FATAL;
  try {
    const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    return said_all(artcal::run_program(arguments, [&] { artcal::hide_passwords(argc, argv); }));
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "artcal: there is not enough memory for this input\n");
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) {  // fmt throws where a long text cannot be written
      return not_all_said();
    }
    fmt::print(stderr, "artcal: {}\n", artcal::text_of_exception(error));
  }
  return bad_input;
}
