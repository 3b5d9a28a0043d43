#include "app/report/html.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/in_quotes.h"

namespace artcal::html {
namespace {

constexpr std::size_t longest = 4000;
constexpr std::size_t most_of_a_short_table = 12;

std::string cell_markup(const Column& column, const std::string& cell) {
  const char* kind = column.is_number ? " class=\"number\"" : column.is_whole ? " class=\"whole\"" : "";
  return column.is_heading ? fmt::format("<th scope=\"row\"{}>{}</th>", kind, cell)
                           : fmt::format("<td{}>{}</td>", kind, cell);
}

}  // namespace

std::string text(std::string_view found) {
  std::string escaped;
  for (const char c : at_most(longest, found)) {
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
    markup.push_back(text(cell));
  }
  add_markup(markup);
}

void Table::add_markup(const std::vector<std::string>& cells, std::string_view row_class) {
  rows_.push_back({cells, std::string(row_class)});
}

std::string Table::markup(std::string_view attributes) const {
  std::vector<std::size_t> shown;
  std::string head, body;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    const auto says_nothing = [&](const Row& row) { return row.cells.at(i) == "–"; };
    if (!column.may_go || !std::all_of(rows_.begin(), rows_.end(), says_nothing)) {
      shown.push_back(i);
      head +=
          fmt::format("<th scope=\"col\"{}>{}</th>", column.is_number ? " class=\"number\"" : "", text(column.heading));
    }
  }
  for (const Row& row : rows_) {
    body += row.row_class.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", row.row_class);
    for (const std::size_t i : shown) {
      body += cell_markup(columns_[i], row.cells.at(i));
    }
    body += "</tr>\n";
  }
  return fmt::format(
      "<div class=\"table{}\"><table{}{}>\n<caption>{}</caption>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>"
      "</table></div>\n",
      rows_.size() <= most_of_a_short_table ? " short" : "", attributes.empty() ? "" : " ", attributes, caption_, head,
      body);
}

}  // namespace artcal::html
