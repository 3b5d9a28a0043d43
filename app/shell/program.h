#pragma once

#include <functional>
#include <string>
#include <vector>

namespace artcal {

/// Parses a command line, without the program's name, and runs its command. Returns the exit code (core/error.h; 0:
/// done, 1: done and a verification failed). `parsed` is called in between. What is said goes to standard output and
/// standard error, or to the thread's Capture (app/output/capture.h).
int run_program(const std::vector<std::string>& arguments, const std::function<void()>& parsed = {});

}  // namespace artcal
