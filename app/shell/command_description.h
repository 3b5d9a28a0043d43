#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/shell/value_rule.h"

namespace artcal {

/// An option or a positional argument as help, manual pages and completion state it.
struct OptionDescription {
  std::vector<std::string> names;  ///< such as -o, --output; empty for a positional argument
  std::string value;               ///< what follows the name, such as ARM; empty for a flag
  ValueRule rule;                  ///< which values are accepted
  std::string default_value;       ///< as it is typed; empty where there is none
  std::string text;
  bool required = false;
  bool repeats = false;  ///< takes several values
  std::vector<std::string> needs, excludes;

  /// The text, and in brackets what is accepted, the default, and what it goes with.
  [[nodiscard]] std::string full_text() const;
};

/// A command, from the parser that also reads the command line: the one source of all that is said about it.
struct CommandDescription {
  std::vector<std::string> path;  ///< such as artcal, store, merge
  std::string summary;
  std::vector<OptionDescription> arguments, options;
  std::vector<CommandDescription> commands;
  std::string footer;

  [[nodiscard]] std::string name() const;  ///< the path, words separated by spaces
  /// Such as "artcal identify [OPTIONS] RECORDING".
  [[nodiscard]] std::string usage() const;
};

OptionDescription describe_option(const CLI::Option& option);
/// Describes a command with all its commands inside, in the order in which they were added.
CommandDescription describe(const CLI::App& parser);

/// Such as "-o, --output ARM", "--quiet" or "RECORDING".
std::string heading(const OptionDescription& option);

}  // namespace artcal
