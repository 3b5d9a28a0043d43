#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/shell/completion.h"

namespace artcal {
namespace {

std::string in_fish_quotes(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return result + "'";
}

// What completes a value; -r says that there is one, -f that it is no file.
std::string value_words(const OptionDescription& option) {
  if (!option.rule.choices.empty()) {
    return fmt::format(" -r -f -a {}", in_fish_quotes(fmt::format("{}", fmt::join(option.rule.choices, " "))));
  }
  const FileKind kind = file_kind(option.value);
  switch (kind.kind) {
    case FileKind::Kind::None: return " -x";
    case FileKind::Kind::Folders: return " -x -a '(__fish_complete_directories (commandline -ct))'";
    default: break;
  }
  std::string words = kind.endings.empty() ? " -r -F" : " -r -f";
  for (const std::string& ending : kind.endings) {
    words += fmt::format(" -a '(__fish_complete_suffix .{})'", ending);
  }
  return words;
}

std::string condition(const CommandDescription& command) {
  std::string text;
  for (std::size_t i = 1; i < command.path.size(); ++i) {
    text += fmt::format("{}__fish_seen_subcommand_from {}", i == 1 ? "" : "; and ", command.path[i]);
  }
  if (!command.commands.empty()) {
    std::vector<std::string> inside;
    for (const CommandDescription& one : command.commands) {
      inside.push_back(one.path.back());
    }
    text += fmt::format("{}not __fish_seen_subcommand_from {}", text.empty() ? "" : "; and ", fmt::join(inside, " "));
  }
  return in_fish_quotes(text);
}

void add_lines(const CommandDescription& command, std::string& script) {
  const std::string when = "complete -c artcal -n " + condition(command);
  for (const OptionDescription& option : command.options) {
    script += when;
    for (const std::string& name : option.names) {
      script += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    script += (option.value.empty() ? "" : value_words(option)) + " -d " + in_fish_quotes(option.text) + "\n";
  }
  if (!command.arguments.empty()) {
    const OptionDescription& argument = command.arguments.front();
    const bool has_words = !argument.rule.choices.empty() || file_kind(argument.value).kind != FileKind::Kind::None;
    script += has_words ? when + value_words(argument) + "\n" : "";
  }
  for (const CommandDescription& inside : command.commands) {
    script += fmt::format("{} -f -a {} -d {}\n", when, inside.path.back(), in_fish_quotes(inside.summary));
  }
  for (const CommandDescription& inside : command.commands) {
    add_lines(inside, script);
  }
}

}  // namespace

std::string fish_completion(const CommandDescription& program) {
  std::string script = "# fish completion of artcal; made by `artcal completion fish`\ncomplete -c artcal -f\n";
  add_lines(program, script);
  return script;
}

}  // namespace artcal
