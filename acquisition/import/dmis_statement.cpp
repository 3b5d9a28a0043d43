#include "acquisition/import/dmis_statement.h"

#include <algorithm>

#include "core/text/trimmed.h"

namespace artcal {
namespace {

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return capitals;
}

// What of a line stands before $$, which begins a comment outside of quotes.
std::string_view without_comment(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    quoted = quoted != (line[i] == '\'');
    if (!quoted && line.substr(i).starts_with("$$")) {
      return line.substr(0, i);
    }
  }
  return line;
}

// What commas separate outside of quotes and brackets.
std::vector<std::string> fields_of(std::string_view text) {
  std::vector<std::string> fields;
  bool quoted = false;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ',';
    quoted = quoted != (c == '\'');
    depth += quoted ? 0 : (c == '(' ? 1 : c == ')' ? -1 : 0);
    if (i == text.size() || (c == ',' && !quoted && depth <= 0)) {
      fields.emplace_back(trimmed(text.substr(begin, i - begin)));
      begin = i + 1;
    }
  }
  return fields;
}

DmisStatement parsed_statement(std::string_view text, int line) {
  DmisStatement statement;
  statement.line = line;
  std::string_view rest = trimmed(text);
  const std::size_t open = rest.find('('), close = rest.find(')');
  const std::size_t equal = close == std::string_view::npos ? close : rest.find_first_not_of(" \t", close + 1);
  if (open < close && equal != std::string_view::npos && rest[equal] == '=' &&
      rest.substr(0, open).find('/') == std::string_view::npos) {
    statement.label_kind = in_capitals(trimmed(rest.substr(0, open)));
    statement.label = std::string(trimmed(rest.substr(open + 1, close - open - 1)));
    rest = trimmed(rest.substr(equal + 1));
  }
  const std::size_t slash = rest.find('/');
  if (slash == std::string_view::npos) {
    statement.major = in_capitals(rest);  // ENDMES
    return statement;
  }
  statement.major = in_capitals(trimmed(rest.substr(0, slash)));
  statement.fields = fields_of(rest.substr(slash + 1));
  for (std::string& field : statement.fields) {
    // Names keep their case, words have none.
    if (field.find_first_of("'(") == std::string::npos) {
      field = in_capitals(field);
    }
  }
  return statement;
}

}  // namespace

std::vector<DmisStatement> dmis_statements(std::string_view text) {
  std::vector<DmisStatement> statements;
  std::string joined;
  int line = 0, first = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    ++line;
    std::string_view part = trimmed(without_comment(text.substr(begin, end - begin)));
    begin = end + 1;
    first = joined.empty() ? line : first;
    const bool goes_on = part.ends_with('$');
    part.remove_suffix(goes_on ? 1 : 0);
    joined += part;
    if (goes_on && begin < text.size()) {
      continue;
    }
    if (!joined.empty()) {
      statements.push_back(parsed_statement(joined, first));
    }
    joined.clear();
  }
  return statements;
}

std::string name_in(std::string_view field, std::string_view kind) {
  const std::size_t open = field.find('(');
  if (open == std::string_view::npos || field.back() != ')' || in_capitals(trimmed(field.substr(0, open))) != kind) {
    return {};
  }
  return std::string(trimmed(field.substr(open + 1, field.size() - open - 2)));
}

}  // namespace artcal
