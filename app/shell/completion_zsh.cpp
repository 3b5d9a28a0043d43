#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/shell/completion.h"

namespace artcal {
namespace {

// Inside single quotes; _arguments reads ':', '[' and ']' itself.
std::string zsh_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else if (c == ':' || c == '[' || c == ']' || c == '\\') {
      result += std::string("\\") + c;
    } else {
      result += c;
    }
  }
  return result;
}

// A pattern's last brackets are qualifiers of it: (-.) are files, links to them too.
std::string action(const OptionDescription& option) {
  const std::string name = zsh_escaped(option.value);
  if (!option.rule.choices.empty()) {
    return fmt::format(":{}:({})", name, fmt::join(option.rule.choices, " "));
  }
  const FileKind kind = file_kind(option.value);
  switch (kind.kind) {
    case FileKind::Kind::None: return fmt::format(":{}: ", name);
    case FileKind::Kind::Folders: return fmt::format(":{}:_files -/", name);
    default:
      return kind.endings.empty() ? fmt::format(":{}:_files", name)
                                  : fmt::format(":{}:_files -g \"*.({})(-.)\"", name, fmt::join(kind.endings, "|"));
  }
}

std::string function_name(const CommandDescription& command) {
  return fmt::format("_{}", fmt::join(command.path, "_"));
}

void add_function(const CommandDescription& command, std::string& script) {
  script += function_name(command) + "() {\n  local -a commands\n  local state line\n  _arguments -S -C";
  for (const OptionDescription& option : command.options) {
    for (const std::string& name : option.names) {
      script += fmt::format(" \\\n    '({})'{}'[{}]{}'", fmt::join(option.names, " "), name, zsh_escaped(option.text),
                            option.value.empty() ? "" : action(option));
    }
  }
  if (!command.commands.empty()) {
    script += " \\\n    '1: :->command' '*:: :->inside'\n  case $state in\n  command)\n    commands=(";
    for (const CommandDescription& inside : command.commands) {
      script += fmt::format("\n      '{}:{}'", inside.path.back(), zsh_escaped(inside.summary));
    }
    script += "\n    )\n    _describe command commands ;;\n  inside)\n    case $words[1] in\n";
    for (const CommandDescription& inside : command.commands) {
      script += fmt::format("    {}) {} ;;\n", inside.path.back(), function_name(inside));
    }
    script += "    esac ;;\n  esac\n}\n";
  } else {
    for (std::size_t i = 0; i < command.arguments.size(); ++i) {
      const OptionDescription& argument = command.arguments[i];
      script += fmt::format(" \\\n    '{}{}'", argument.repeats ? "*" : std::to_string(i + 1), action(argument));
    }
    script += "\n}\n";
  }
  for (const CommandDescription& inside : command.commands) {
    add_function(inside, script);
  }
}

}  // namespace

std::string zsh_completion(const CommandDescription& program) {
  std::string script = "#compdef artcal\n# zsh completion of artcal; made by `artcal completion zsh`\n";
  add_function(program, script);
  // Loaded by compinit the file is the function's body; sourced, it states what it completes.
  script += "if [[ ${funcstack[1]} == _artcal ]]; then\n  _artcal \"$@\"\nelse\n  compdef _artcal artcal\nfi\n";
  return script;
}

}  // namespace artcal
