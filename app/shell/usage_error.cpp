#include "app/shell/usage_error.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/shell/closest_word.h"
#include "app/shell/command_description.h"
#include "core/text/decimal_comma.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// The innermost command that the words name, one inside the other.
const CLI::App& command_of(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* at = &program;
  for (const std::string& word : words) {
    const CLI::App* inside = command_in(*at, word);
    if (inside == nullptr) {
      break;
    }
    at = inside;
  }
  return *at;
}

bool is_option_word(const std::string& word) {
  const bool is_number = word.size() > 1 && (word[1] == '.' || (word[1] >= '0' && word[1] <= '9'));
  return word.size() > 1 && word.front() == '-' && !is_number;
}

std::string name_of(const CLI::Option& option) {
  return option.get_positional() ? shown_type(option.get_type_name()) : option.get_name();
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

std::optional<std::string> extra_words(const CLI::App& command, const std::vector<std::string>& extra) {
  const auto option = std::find_if(extra.begin(), extra.end(), is_option_word);
  if (option != extra.end()) {
    const std::string name = option->substr(0, option->find('='));
    return fmt::format("there is no option {}{}", in_quotes(name), did_you_mean(name, option_names(command)));
  }
  if (extra.empty()) {
    return std::nullopt;
  }
  return fmt::format("{} is one argument too many, expected {}", in_quotes(extra.front()), describe(command).usage());
}

std::optional<std::string> missing(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_required() && option->count() == 0) {
      names.push_back(name_of(*option));
    }
  }
  if (names.empty()) {
    return std::nullopt;
  }
  return fmt::format("{} {} missing, expected {}{}", fmt::join(names, " and "), names.size() == 1 ? "is" : "are",
                     describe(command).usage(), [&] {
                       std::string options;
                       for (const std::string& name : names) {
                         options += name.starts_with("--") ? " " + name + " …" : "";
                       }
                       return options;
                     }());
}

std::optional<std::string> at_odds(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) {
      continue;
    }
    for (const CLI::Option* other : option->get_needs()) {
      if (other->count() == 0) {
        return fmt::format("{} has a meaning only together with {}, which is missing", name_of(*option),
                           name_of(*other));
      }
    }
    for (const CLI::Option* other : option->get_excludes()) {
      if (other->count() > 0) {
        return fmt::format("{} and {} exclude each other; leave one out", name_of(*option), name_of(*other));
      }
    }
  }
  return std::nullopt;
}

// The option that the parser's message is about: the one with the longest name in it.
const CLI::Option* option_in(const CLI::App& command, const std::string& message) {
  const CLI::Option* found = nullptr;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (message.find(name) != std::string::npos && (found == nullptr || name.size() > found->get_name().size())) {
      found = option;
    }
  }
  return found;
}

std::string expectation(const ValueRule& rule) {
  const std::string expected = rule.expected();
  return expected.empty() ? "" : ", expected " + expected;
}

// What was typed: the parser keeps a changed value where it converts one, and the pieces of a list.
std::string typed_value(const CLI::Option& option, const std::vector<std::string>& arguments) {
  for (const std::string& name : describe_option(option).names) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (arguments[i] == name && i + 1 < arguments.size()) {
        return arguments[i + 1];
      }
      if (arguments[i].starts_with(name + "=")) {
        return arguments[i].substr(name.size() + 1);
      }
    }
  }
  return fmt::format("{}", fmt::join(option.results(), ","));
}

std::string wrong_value(const CLI::Option& option, const std::string& value) {
  const ValueRule rule = value_rule(option.get_type_name());
  const std::string expected =
      rule.expected().empty()
          ? fmt::format(", expected {}: {}", shown_type(option.get_type_name()), option.get_description())
          : expectation(rule);
  return fmt::format("{} is {}{}{}{}", name_of(option), in_quotes(value), expected, did_you_mean(value, rule.choices),
                     decimal_comma_question(value));
}

// How often the option stands on the command line: the parser forgets values that it refuses.
std::string value_sentence(const CLI::Option& option, const CLI::ParseError& error,
                           const std::vector<std::string>& arguments) {
  const std::vector<std::string>& values = option.results();
  if (option.get_type_size() == 0) {
    return fmt::format("{} takes no value; leave out what follows it", name_of(option));
  }
  const bool is_count = dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr;
  if (is_count && values.size() > 1) {
    return fmt::format("{} is given {} times, expected once", name_of(option), values.size());
  }
  if (values.empty() || is_count) {
    return fmt::format("{} needs a value{}", name_of(option), expectation(value_rule(option.get_type_name())));
  }
  return wrong_value(option, typed_value(option, arguments));
}

std::string sentence(const CLI::App& program, const CLI::App& command, const CLI::ParseError& error,
                     const std::vector<std::string>& arguments) {
  if (const auto extra = extra_words(command, program.remaining(true))) {
    return *extra;
  }
  const bool is_about_value = dynamic_cast<const CLI::ValidationError*>(&error) != nullptr ||
                              dynamic_cast<const CLI::ConversionError*>(&error) != nullptr ||
                              dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr;
  if (const CLI::Option* option = option_in(command, error.what()); is_about_value && option != nullptr) {
    return value_sentence(*option, error, arguments);
  }
  if (const auto absent = missing(command)) {
    return *absent;
  }
  if (const auto contradiction = at_odds(command)) {
    return *contradiction;
  }
  if (const auto names = command_names(command); !names.empty()) {
    return fmt::format("a command is missing, expected one of {}", fmt::join(names, ", "));
  }
  return "the command line is not understood";
}

std::string with_help(const std::string& sentence, const std::string& help) {
  return sentence + (sentence.ends_with('?') ? " See " : "; see ") + help;
}

}  // namespace

const CLI::App* command_in(const CLI::App& parser, const std::string& name) {
  const auto inside = parser.get_subcommands([&](const CLI::App* app) { return app->get_name() == name; });
  return inside.empty() ? nullptr : inside.front();
}

std::vector<std::string> command_names(const CLI::App& parser) {
  std::vector<std::string> names;
  for (const CLI::App* command : parser.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return names;
}

std::string unknown_command(const CLI::App& parser, const std::string& name) {
  return fmt::format("there is no command {}{}", in_quotes(name), did_you_mean(name, command_names(parser)));
}

std::string usage_sentence(const CLI::App& program, const CLI::ParseError& error,
                           const std::vector<std::string>& arguments) {
  const CLI::App& command = command_of(program, arguments);
  const std::string help = describe(command).name() + " --help";
  const auto names = command_names(command);
  const std::size_t depth = describe(command).path.size() - 1;
  if (!names.empty() && arguments.size() > depth && !is_option_word(arguments[depth])) {
    return with_help(unknown_command(command, arguments[depth]), help);
  }
  return with_help(sentence(program, command, error, arguments), help);
}

}  // namespace artcal
