#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/error.h"

namespace artcal {

/// One thing that a new file depends on: an option of the command line, and a question on a terminal.
struct Choice {
  std::string option;                                ///< "--joints"
  std::string type;                                  ///< of its value, as help shows it
  std::string question;                              ///< "number of joints"
  std::string* value = nullptr;                      ///< its default, and then the answer
  std::vector<std::string> among;                    ///< the only answers; empty: whatever `is_right` takes
  std::function<bool(const std::string&)> is_right;  ///< none: any
  std::string expected;                              ///< what the sentence of a refusal says was expected
  int lowest = 0, highest = 0;                       ///< of a whole number; 0: it is none
};

/// Adds the options of these choices.
void add_choices(CLI::App& parser, const std::vector<Choice>& choices);

/// Usage error for the first choice whose value is none of what it takes.
Expected<void> check_choices(const std::vector<Choice>& choices);

/// Whether any of the options was given.
bool any_given(const CLI::App& parser, const std::vector<Choice>& choices);

/// Asks for each value in turn, the default in brackets, until the answer is one; an empty answer is the default. Usage
/// error where the input ends first.
Expected<void> ask(const std::vector<Choice>& choices, std::istream& in, std::ostream& out);

}  // namespace artcal
