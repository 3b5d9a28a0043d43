#include "app/shell/program.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands/command_table.h"
#include "app/output/output.h"
#include "app/shell/command_line_paths.h"
#include "app/shell/help_text.h"
#include "app/shell/usage_error.h"
#include "app/version.h"

namespace artcal {

int run_program(const std::vector<std::string>& arguments, const std::function<void()>& parsed) {
  CLI::App parser{"artcal: artefact-based calibration of articulated-arm coordinate measuring machines", "artcal"};
  parser.formatter(std::make_shared<HelpFormatter>());
  parser.option_defaults()->always_capture_default();
  parser.set_help_flag("-h,--help", "print this help");
  parser.set_version_flag("--version", fmt::format("artcal {}", program_version), "print the version");
  parser.require_subcommand(1);
  parser.footer("`artcal help COMMAND` says more, with an example.");
  std::vector<Run> runs;
  for (const Command& command : command_table()) {
    runs.push_back(command.set_up(*parser.add_subcommand(command.name, command.summary)));
  }
  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // as the parser takes them
    parser.parse(reversed);
  } catch (const CLI::Success& asked) {  // for help or the version
    return parser.exit(asked, std::cout, std::cerr);
  } catch (const CLI::ParseError& error) {
    return report_error(wrong_usage(usage_sentence(parser, error, arguments)).value());
  }
  note_command_line_paths(parser);
  if (parsed) {
    parsed();
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (parser.got_subcommand(command_table()[i].name)) {
      return runs[i]();
    }
  }
  return static_cast<int>(ErrorCode::Usage);
}

}  // namespace artcal
