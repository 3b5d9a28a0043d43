#include "app/report/html.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal::html {
namespace {

constexpr std::size_t longest = 4000;
constexpr std::size_t max_of_a_short_table = 12;
constexpr std::size_t longest_whole_word = 28;  // characters
constexpr std::size_t max_columns_of_a_narrow_table = 4;
constexpr std::size_t max_columns_with_much_room = 8;

std::string column_class(const Column& column) {
  const std::string kind = column.is_number ? "number" : column.is_whole ? "whole" : "";
  return column.is_answer ? kind + (kind.empty() ? "answer" : " answer") : kind;
}

std::string cell_markup(const Column& column, const std::string& cell) {
  const std::string kind = column_class(column);
  const std::string attribute = kind.empty() ? "" : fmt::format(" class=\"{}\"", kind);
  return column.is_heading ? fmt::format("<th scope=\"row\"{}>{}</th>", attribute, cell)
                           : fmt::format("<td{}>{}</td>", attribute, cell);
}

// Of UTF-8.
std::size_t characters(std::string_view word) {
  return static_cast<std::size_t>(std::count_if(word.begin(), word.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string piece_markup(std::string_view piece) {
  return characters(piece) > longest_whole_word ? fmt::format("<span class=\"long\">{}</span>", text(piece))
                                                : text(piece);
}

// With places to break behind its punctuation.
std::string long_word_markup(std::string_view word) {
  std::string markup;
  for (std::size_t begin = 0; begin < word.size();) {
    const std::size_t sign = word.find_first_of("/\\_-.:;,=&|", begin);
    const std::size_t end = sign == std::string_view::npos ? word.size() : sign + 1;
    markup += (begin > 0 ? "<wbr>" : "") + piece_markup(word.substr(begin, end - begin));
    begin = end;
  }
  return markup;
}

// A string of CSS in an attribute: the headings are the program's own words.
std::string css_heading(std::string_view heading) { return fmt::format("'{}'", text(heading)); }

}  // namespace

std::string text(std::string_view found) {
  std::string escaped;
  for (const char c : truncated(longest, found)) {
    switch (c) {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      case '\'': escaped += "&#39;"; break;
      default: escaped += c;
    }
  }
  return escaped;
}

std::string cell(std::string_view found) {
  const std::string whole = truncated(longest, found);
  std::string markup;
  for (std::size_t begin = 0; begin <= whole.size();) {
    const std::size_t end = std::min(whole.find(' ', begin), whole.size());
    const std::string_view word = std::string_view(whole).substr(begin, end - begin);
    markup += (begin > 0 ? " " : "") + (characters(word) > longest_whole_word ? long_word_markup(word) : text(word));
    begin = end + 1;
  }
  return markup;
}

std::string element(std::string_view tag, std::string_view content, std::string_view attributes) {
  return fmt::format("<{}{}{}>{}</{}>\n", tag, attributes.empty() ? "" : " ", attributes, content, tag);
}

std::string data(const nlohmann::ordered_json& json) {
  std::string escaped;
  for (const char c : json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace)) {
    switch (c) {
      case '<': escaped += "\\u003c"; break;
      case '>': escaped += "\\u003e"; break;
      case '&': escaped += "\\u0026"; break;
      default: escaped += c;
    }
  }
  return escaped;
}

Table::Table(std::string_view caption, std::vector<Column> columns)
    : caption_(text(caption)), columns_(std::move(columns)) {}

void Table::add(const std::vector<std::string>& cells) {
  std::vector<std::string> markup;
  for (const std::string& cell : cells) {
    markup.push_back(html::cell(cell));
  }
  add_markup(markup);
}

void Table::add_markup(const std::vector<std::string>& cells, std::string_view row_class) {
  rows_.push_back({cells, std::string(row_class)});
}

std::string Table::markup(std::string_view attributes) const {
  std::vector<std::size_t> shown;
  std::string head, body, labels;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    const auto says_nothing = [&](const Row& row) { return row.cells.at(i) == "–"; };
    if (!column.may_go || !std::all_of(rows_.begin(), rows_.end(), says_nothing)) {
      shown.push_back(i);
      head +=
          fmt::format("<th scope=\"col\"{}>{}</th>", column.is_number ? " class=\"number\"" : "", text(column.heading));
      labels += column.is_heading || column.heading.empty()
                    ? ""
                    : fmt::format("--c{}:{};", shown.size(), css_heading(column.heading));
    }
  }
  for (const Row& row : rows_) {
    body += row.row_class.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", row.row_class);
    for (const std::size_t i : shown) {
      body += cell_markup(columns_[i], row.cells.at(i));
    }
    body += "</tr>\n";
  }
  const bool is_wide = shown.size() > max_columns_of_a_narrow_table;
  return fmt::format(
      "<div class=\"table{}{}\"{}><table{}{}>\n<caption>{}</caption>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>"
      "</table></div>\n",
      rows_.size() <= max_of_a_short_table ? " short" : "",
      !is_wide                                    ? ""
      : shown.size() > max_columns_with_much_room ? " wide dense"
                                                  : " wide",
      is_wide ? fmt::format(" style=\"{}\"", labels) : "", attributes.empty() ? "" : " ", attributes, caption_, head,
      body);
}

}  // namespace artcal::html
