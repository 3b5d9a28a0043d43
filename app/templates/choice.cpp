#include "app/templates/choice.h"

#include <algorithm>
#include <istream>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text/in_quotes.h"
#include "core/text/trimmed.h"

namespace artcal {
namespace {

std::string expected_of(const Choice& choice) {
  return choice.among.empty() ? choice.expected : fmt::format("one of {}", fmt::join(choice.among, ", "));
}

bool accepts(const Choice& choice, const std::string& value) {
  if (find_control(value)) {
    return false;
  }
  if (!choice.among.empty()) {
    return std::find(choice.among.begin(), choice.among.end(), value) != choice.among.end();
  }
  return !choice.is_right || choice.is_right(value);
}

}  // namespace

void add_choices(CLI::App& parser, const std::vector<Choice>& choices) {
  for (const Choice& choice : choices) {
    CLI::Option* option = parser.add_option(choice.option, *choice.value, choice.question);
    if (choice.among.empty()) {
      option->type_name(choice.type);
    } else {
      option->check(CLI::IsMember(choice.among));
    }
    if (choice.highest > 0) {
      option->check(CLI::Range(choice.lowest, choice.highest));
    }
  }
}

Expected<void> check_choices(const std::vector<Choice>& choices) {
  for (const Choice& choice : choices) {
    if (!accepts(choice, *choice.value)) {
      return wrong_usage(
          fmt::format("{} is {}, expected {}", choice.option, in_quotes(*choice.value), expected_of(choice)));
    }
  }
  return {};
}

bool any_given(const CLI::App& parser, const std::vector<Choice>& choices) {
  return std::any_of(choices.begin(), choices.end(),
                     [&](const Choice& choice) { return parser.count(choice.option) > 0; });
}

Expected<void> ask(const std::vector<Choice>& choices, std::istream& in, std::ostream& out) {
  for (const Choice& choice : choices) {
    const std::string words = choice.among.empty() ? "" : fmt::format(" ({})", fmt::join(choice.among, ", "));
    for (bool answered = false; !answered;) {
      out << fmt::format("{}{} [{}]: ", choice.question, words, *choice.value) << std::flush;
      std::string line;
      if (!std::getline(in, line)) {
        return wrong_usage("the input ended before the questions were answered; nothing was written");
      }
      const std::string answer(trimmed(line));
      answered = answer.empty() ? accepts(choice, *choice.value) : accepts(choice, answer);
      if (answered && !answer.empty()) {
        *choice.value = answer;
      }
      if (!answered) {
        out << fmt::format("  {} is not {}\n", in_quotes(answer), expected_of(choice));
      }
    }
  }
  return {};
}

}  // namespace artcal
