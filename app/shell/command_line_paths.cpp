#include "app/shell/command_line_paths.h"

#include <map>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/shell/value_rule.h"

namespace artcal {
namespace {

// Path and option.
std::map<std::string, std::string>& noted() {
  thread_local std::map<std::string, std::string> paths;
  return paths;
}

void note(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::string type = shown_type(option->get_type_name());
    if (option->count() == 0 || file_kind(type).kind == FileKind::Kind::None) {
      continue;
    }
    for (const std::string& path : option->results()) {
      noted().emplace(path, option->get_positional() ? type : option->get_name());
    }
  }
  for (const CLI::App* inside : command.get_subcommands()) {  // those on the command line
    note(*inside);
  }
}

}  // namespace

void note_command_line_paths(const CLI::App& program) {
  noted().clear();
  for (const CLI::App* command : program.get_subcommands()) {
    note(*command);
  }
}

std::string text_with_origin(const Error& error) {
  const auto path = noted().find(error.where);
  if (path == noted().end() || error.kind != ErrorKind::MissingFile) {
    return error.text();
  }
  Error named = error;
  named.message.insert(error.found.size(), fmt::format(", named on the command line as {}", path->second));
  return named.text();
}

}  // namespace artcal
