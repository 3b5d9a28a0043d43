#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/shell/command_description.h"

namespace artcal {

/// What `--help` prints: lines of at most 100 characters.
std::string help_text(const CommandDescription& command);

/// What follows the options: prose first, then examples, lines that begin with two spaces, with what heads them.
struct Footer {
  std::string prose;
  std::vector<std::string> examples;  ///< without the two spaces
};
Footer parse_footer(std::string_view footer);

/// Lets the parser print help_text().
class HelpFormatter : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* parser, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace artcal
