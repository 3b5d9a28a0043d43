#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/shell/completion.h"

namespace artcal {
namespace {

// The reply for a value: its choices, or files of its kind.
std::string reply(const OptionDescription& option) {
  if (!option.rule.choices.empty()) {
    return fmt::format("_artcal_words '{}'", fmt::join(option.rule.choices, " "));
  }
  const FileKind kind = file_kind(option.value);
  switch (kind.kind) {
    case FileKind::Kind::None: return "return";
    case FileKind::Kind::Folders: return "_artcal_folders";
    default: return fmt::format("_artcal_files {}", fmt::join(kind.endings, " "));
  }
}

std::string option_words(const CommandDescription& command) {
  std::vector<std::string> words;
  for (const OptionDescription& option : command.options) {
    words.insert(words.end(), option.names.begin(), option.names.end());
  }
  return fmt::format("{}", fmt::join(words, " "));
}

std::string command_words(const CommandDescription& command) {
  std::vector<std::string> words;
  for (const CommandDescription& inside : command.commands) {
    words.push_back(inside.path.back());
  }
  return fmt::format("{}", fmt::join(words, " "));
}

// A case for each value that follows an option, one for options, one for arguments.
void add_cases(const CommandDescription& command, std::string& script) {
  const std::string name = command.name();
  for (const OptionDescription& option : command.options) {
    if (option.value.empty()) {
      continue;
    }
    std::vector<std::string> patterns;
    for (const std::string& word : option.names) {
      patterns.push_back(fmt::format("'{} after {}'*", name, word + " "));
    }
    script += fmt::format("    {}) {} ;;\n", fmt::join(patterns, "|"), reply(option));
  }
  script += fmt::format("    '{} '*' -'*) _artcal_words '{}' ;;\n", name + " after", option_words(command));
  if (!command.commands.empty()) {
    script += fmt::format("    '{} after '*) _artcal_words '{}' ;;\n", name, command_words(command));
  } else if (!command.arguments.empty()) {
    script += fmt::format("    '{} after '*) {} ;;\n", name, reply(command.arguments.front()));
  }
  for (const CommandDescription& inside : command.commands) {
    add_cases(inside, script);
  }
}

void add_names(const CommandDescription& command, std::vector<std::string>& names) {
  for (const CommandDescription& inside : command.commands) {
    names.push_back(fmt::format("'{}'", inside.name()));
    add_names(inside, names);
  }
}

}  // namespace

std::string bash_completion(const CommandDescription& program) {
  std::vector<std::string> names;
  add_names(program, names);
  std::string script = R"(# bash completion of artcal; made by `artcal completion bash`
_artcal_words() { COMPREPLY=($(compgen -W "$1" -- "$artcal_word")); }
_artcal_folders() { local IFS=$'\n'; COMPREPLY=($(compgen -d -- "$artcal_word")); }
_artcal_files() {
  local IFS=$'\n' ending
  if (($# == 0)); then
    COMPREPLY=($(compgen -f -- "$artcal_word"))
    return
  fi
  COMPREPLY=($(compgen -d -- "$artcal_word"))
  for ending in "$@"; do
    COMPREPLY+=($(compgen -f -X "!*.$ending" -- "$artcal_word"))
  done
}
_artcal() {
  local artcal_word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=artcal i
  COMPREPLY=()
  if [[ $artcal_word == = ]]; then
    artcal_word=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD-2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${COMP_WORDS[i]}" in
)";
  script += fmt::format("    {}) command=\"$command ${{COMP_WORDS[i]}}\" ;;\n", fmt::join(names, "|"));
  script += "    esac\n  done\n  case \"$command after $before $artcal_word\" in\n";
  add_cases(program, script);
  script += "  esac\n}\ncomplete -o filenames -F _artcal artcal\n";
  return script;
}

}  // namespace artcal
