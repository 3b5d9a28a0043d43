#include "app/shell/command_description.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace artcal {
namespace {

// The parser shows an empty list, an empty text and the like as defaults; a person types none of them.
std::string typed_default(const CLI::Option& option) {
  const std::string text = option.get_default_str();
  const bool is_none = text == "[]" || text == "{}" || text == "\"\"" || text == "false";
  return is_none ? "" : text;
}

std::vector<std::string> names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) {
    names.push_back(option->get_name());
  }
  std::sort(names.begin(), names.end());  // the set is sorted by address
  return names;
}

std::vector<std::string> path_of(const CLI::App& parser) {
  std::vector<std::string> path;
  for (const CLI::App* at = &parser; at != nullptr; at = at->get_parent()) {
    path.insert(path.begin(), at->get_name());
  }
  return path;
}

std::string one_argument(const OptionDescription& argument) {
  const bool has_mark = argument.value.ends_with("…");
  const std::string name = argument.value + (argument.repeats && !has_mark ? "…" : "");
  return argument.required ? name : "[" + name + "]";
}

}  // namespace

std::string OptionDescription::full_text() const {
  std::vector<std::string> remarks;
  if (const std::string accepted = rule.shortly(); !accepted.empty()) {
    remarks.push_back(accepted);
  }
  if (!default_value.empty()) {
    remarks.push_back("default " + default_value);
  }
  if (required && !names.empty()) {
    remarks.emplace_back("required");
  }
  if (!needs.empty()) {
    remarks.push_back(fmt::format("with {}", fmt::join(needs, ", ")));
  }
  if (!excludes.empty()) {
    remarks.push_back(fmt::format("not with {}", fmt::join(excludes, ", ")));
  }
  return remarks.empty() ? text : fmt::format("{} ({})", text, fmt::join(remarks, "; "));
}

std::string CommandDescription::name() const { return fmt::format("{}", fmt::join(path, " ")); }

std::string CommandDescription::usage() const {
  std::string text = name() + (commands.empty() ? " [OPTIONS]" : " COMMAND …");
  for (const OptionDescription& argument : arguments) {
    text += " " + one_argument(argument);
  }
  return text;
}

OptionDescription describe_option(const CLI::Option& option) {
  OptionDescription described;
  for (const std::string& name : option.get_snames()) {
    described.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    described.names.push_back("--" + name);
  }
  const std::string type = option.get_type_name();
  if (option.get_type_size() != 0) {
    described.value = shown_type(type);
    described.rule = value_rule(type);
    described.default_value = typed_default(option);
  }
  if (described.names.empty() && described.value.empty()) {
    described.value = option.get_name();
  }
  described.text = option.get_description();
  described.required = option.get_required();
  described.repeats = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  described.needs = names_of(option.get_needs());
  described.excludes = names_of(option.get_excludes());
  return described;
}

CommandDescription describe(const CLI::App& parser) {
  CommandDescription described;
  described.path = path_of(parser);
  described.summary = parser.get_description();
  described.footer = parser.get_footer();
  for (const CLI::Option* option : parser.get_options()) {
    if (!option->get_group().empty()) {
      (option->get_positional() ? described.arguments : described.options).push_back(describe_option(*option));
    }
  }
  for (const CLI::App* command :
       parser.get_subcommands([](const CLI::App* app) { return !app->get_group().empty(); })) {
    described.commands.push_back(describe(*command));
  }
  return described;
}

std::string heading(const OptionDescription& option) {
  std::string text = fmt::format("{}", fmt::join(option.names, ", "));
  if (!option.value.empty()) {
    text += (text.empty() ? "" : " ") + option.value;
  }
  return option.repeats && !text.ends_with("…") ? text + "…" : text;
}

}  // namespace artcal
