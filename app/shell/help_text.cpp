#include "app/shell/help_text.h"

#include <sstream>

#include <fmt/format.h>

#include "app/shell/paragraph.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t width = 100;
constexpr std::size_t text_column = 28;

std::string entry(const std::string& heading, const std::string& text) {
  const std::string left = "  " + heading;
  const std::size_t length = character_count(left);
  if (text.empty()) {
    return left + "\n";
  }
  const std::string gap =
      length + 2 <= text_column ? std::string(text_column - length, ' ') : "\n" + std::string(text_column, ' ');
  return left + gap + filled(text, width, text_column, text_column) + "\n";
}

std::string section(const std::string& title, const std::vector<OptionDescription>& options) {
  std::string text = options.empty() ? "" : "\n" + title + ":\n";
  for (const OptionDescription& option : options) {
    text += entry(heading(option), option.full_text());
  }
  return text;
}

std::string commands_section(const std::vector<CommandDescription>& commands) {
  std::string text = commands.empty() ? "" : "\nCommands:\n";
  for (const CommandDescription& command : commands) {
    text += entry(command.path.back(), command.summary);
  }
  return text;
}

std::string footer_section(const std::string& footer) {
  const Footer parsed = parse_footer(footer);
  std::string text;
  if (!parsed.prose.empty()) {
    text += "\n" + filled(parsed.prose, width, 0, 0) + "\n";
  }
  if (!parsed.examples.empty()) {
    text += parsed.examples.size() == 1 ? "\nExample:\n" : "\nExamples:\n";
  }
  for (const std::string& example : parsed.examples) {
    text += "  " + example + "\n";
  }
  return text;
}

}  // namespace

Footer parse_footer(std::string_view footer) {
  Footer parsed;
  std::istringstream lines{std::string(footer)};
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  ")) {
      parsed.examples.push_back(line.substr(2));
    } else if (line != "Example:" && line != "Examples:" && !line.empty()) {
      parsed.prose += (parsed.prose.empty() ? "" : " ") + line;
    }
  }
  return parsed;
}

std::string help_text(const CommandDescription& command) {
  const std::string usage = "Usage: ";
  return filled(command.summary, width, 0, 0) + "\n\n" + usage +
         filled(command.usage(), width, usage.size() + 2, usage.size()) + "\n" +
         section("Arguments", command.arguments) + commands_section(command.commands) +
         section("Options", command.options) + footer_section(command.footer);
}

std::string HelpFormatter::make_help(const CLI::App* parser, std::string /*name*/, CLI::AppFormatMode /*mode*/) const {
  return help_text(describe(*parser));
}

}  // namespace artcal
