#include "acquisition/csv/csv_text.h"

#include <algorithm>

#include "acquisition/point_cloud/text_rows.h"

namespace artcal {
namespace {

// What a spreadsheet runs. Behind any apostrophes, so that a label which begins with one is told from a guarded one.
bool is_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
  return !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos && !is_number(text);
}

}  // namespace

std::string csv_field(std::string_view label) {
  const std::string guarded = (is_formula(label) ? "'" : "") + std::string(label);
  // Blanks at an end are kept by quotes alone, and a # would make the first field's line a comment.
  if (guarded.find_first_of(",\"#;\t ") == std::string::npos) {
    return guarded;
  }
  std::string quoted = "\"";
  for (const char c : guarded) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + '"';
}

std::string_view without_guard(std::string_view field) {
  return field.starts_with('\'') && is_formula(field) ? field.substr(1) : field;
}

}  // namespace artcal
