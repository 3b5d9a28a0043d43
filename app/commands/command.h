#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include "core/error.h"

namespace artcal {

/// Exit codes of commands that did what they were asked, but found mistakes or were stopped.
inline constexpr int mistakes_found = 1;
inline constexpr int interrupted = 130;  ///< as shells have it: 128 + SIGINT

/// Runs a command whose options have been parsed; returns the exit code (core/error.h, 0 when done).
using Run = std::function<int()>;

/// One entry of the program's table of commands: adds its options to the parser and returns what to run.
struct Command {
  const char* name;
  const char* summary;
  Run (*set_up)(CLI::App& parser);
};

/// What every command has.
struct CommonOptions {
  std::string json;  ///< file for the result as JSON; "-" is standard output
  bool quiet = false;

  void add_to(CLI::App& parser);
  /// Whether a person is to be told on standard output.
  [[nodiscard]] bool talks() const { return !quiet && json != "-"; }
  /// Says the text to a person, where one is to be told, or gives it to the thread's Capture.
  void say(const std::string& text) const;
  /// Writes the result where JSON is asked for, then says the text to a person; returns the exit code that is given.
  [[nodiscard]] Expected<int> tell(const nlohmann::ordered_json& result, const std::string& text,
                                   int exit_code = 0) const;
};

Run set_up_inspect(CLI::App& parser);
Run set_up_identify(CLI::App& parser);
Run set_up_coupling(CLI::App& parser);
Run set_up_evaluate(CLI::App& parser);
Run set_up_segment(CLI::App& parser);
Run set_up_fit(CLI::App& parser);
Run set_up_uncertainty(CLI::App& parser);
Run set_up_verify(CLI::App& parser);
Run set_up_points(CLI::App& parser);
Run set_up_plan(CLI::App& parser);
Run set_up_simulate(CLI::App& parser);
Run set_up_record(CLI::App& parser);
Run set_up_report(CLI::App& parser);
Run set_up_batch(CLI::App& parser);
Run set_up_store(CLI::App& parser);
Run set_up_history(CLI::App& parser);
Run set_up_convert(CLI::App& parser);
Run set_up_import(CLI::App& parser);
Run set_up_new(CLI::App& parser);
Run set_up_arm(CLI::App& parser);
Run set_up_help(CLI::App& parser);
Run set_up_completion(CLI::App& parser);

}  // namespace artcal
