#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace artcal {

/// One sentence, in the program's own words, about a command line that could not be parsed: what was found, what was
/// expected, and where help is. `arguments` are those of the command line, without the program's name.
std::string usage_sentence(const CLI::App& program, const CLI::ParseError& error,
                           const std::vector<std::string>& arguments);

/// The command of that name inside a command, or null.
const CLI::App* command_in(const CLI::App& parser, const std::string& name);

/// The names of the commands inside a command.
std::vector<std::string> command_names(const CLI::App& parser);

/// "there is no command X; did you mean Y?"
std::string unknown_command(const CLI::App& parser, const std::string& name);

}  // namespace artcal
