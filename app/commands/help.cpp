#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/shell/completion.h"
#include "app/shell/help_text.h"
#include "app/shell/manual_page.h"
#include "app/shell/usage_error.h"
#include "app/version.h"

namespace artcal {
namespace {

struct HelpArguments {
  std::vector<std::string> command;
  bool manual = false;
  std::string shell;
};

Expected<CommandDescription> command_named(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* at = &program;
  for (const std::string& word : words) {
    const CLI::App* inside = command_in(*at, word);
    if (inside == nullptr) {
      return wrong_usage(
          fmt::format("{}; {} --help lists the commands", unknown_command(*at, word), describe(*at).name()));
    }
    at = inside;
  }
  return describe(*at);
}

Expected<int> tell_help(const CLI::App& program, const HelpArguments& arguments) {
  return command_named(program, arguments.command).map([&](const CommandDescription& command) {
    fmt::print("{}", arguments.manual ? manual_page(command, program_version) : help_text(command));
    return 0;
  });
}

int tell_completion(const CLI::App& program, const std::string& shell) {
  const CommandDescription described = describe(program);
  fmt::print("{}", shell == "bash"  ? bash_completion(described)
                   : shell == "zsh" ? zsh_completion(described)
                                    : fish_completion(described));
  return 0;
}

}  // namespace

Run set_up_help(CLI::App& parser) {
  auto arguments = std::make_shared<HelpArguments>();
  parser.add_option("command", arguments->command, "the command to describe; without it the program")
      ->type_name("COMMAND");
  parser.add_flag("--man", arguments->manual, "write the manual page (roff) instead");
  parser.footer("Examples:\n  artcal help identify\n  artcal help store merge\n  artcal help --man identify");
  return [arguments, program = parser.get_parent()] {
    const auto done = tell_help(*program, *arguments);
    return done ? *done : report_error(done.error());
  };
}

Run set_up_completion(CLI::App& parser) {
  auto arguments = std::make_shared<HelpArguments>();
  parser.add_option("shell", arguments->shell, "the shell to write for")
      ->required()
      ->type_name("SHELL")
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  parser.footer(
      "The Debian package installs these scripts. Without it, load one in the shell's start file.\n"
      "Examples:\n  artcal completion bash > ~/.local/share/bash-completion/completions/artcal\n"
      "  artcal completion fish > ~/.config/fish/completions/artcal.fish");
  return [arguments, program = parser.get_parent()] { return tell_completion(*program, arguments->shell); };
}

}  // namespace artcal
