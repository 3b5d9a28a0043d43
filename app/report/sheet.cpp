#include "app/report/sheet.h"

#include <fmt/format.h>

namespace artcal {
namespace {

const char* mood_class(Mood mood) {
  return mood == Mood::Good ? "verdict good" : mood == Mood::Bad ? "verdict bad" : "verdict unsure";
}

}  // namespace

void Sheet::title(std::string_view text) { markup_ += html::element("h1", html::text(text)); }
void Sheet::section(std::string_view text) { markup_ += html::element("h2", html::text(text)); }
void Sheet::part(std::string_view text) { markup_ += html::element("h3", html::text(text)); }
void Sheet::paragraph(std::string_view text) { markup_ += html::element("p", html::text(text)); }
void Sheet::note(std::string_view text) { markup_ += html::element("p", html::text(text), "class=\"note\""); }

void Sheet::verdict(Mood mood, std::string_view headline, std::string_view text) {
  markup_ += html::element("div", html::element("strong", html::text(headline)) + html::text(text),
                           fmt::format("class=\"{}\"", mood_class(mood)));
}

void Sheet::list(const std::vector<std::string>& texts) {
  std::string items;
  for (const std::string& text : texts) {
    items += html::element("li", html::text(text));
  }
  markup_ += texts.empty() ? "" : html::element("ul", items);
}

void Sheet::facts(const std::vector<std::pair<std::string, std::string>>& facts) {
  std::string items;
  for (const auto& [name, value] : facts) {
    if (!value.empty()) {
      items += html::element("dt", html::text(name)) + html::element("dd", html::text(value));
    }
  }
  markup_ += html::element("dl", items, "class=\"facts\"");
}

void Sheet::table(const html::Table& table) {
  if (!table.empty()) {
    markup_ += table.markup();
  }
}

void Sheet::figure(const Figure& figure) {
  const std::string id = fmt::format("figure-{}", figures_.size() + 1);
  const std::string plot = fmt::format(
      "<div class=\"plot{}\" id=\"{}\" role=\"img\" aria-label=\"{}\" aria-describedby=\"{}-caption\">"
      "<noscript>This picture is drawn by JavaScript, which is off. Its key numbers stand below.</noscript></div>",
      figure.tall ? " tall" : "", id, html::text(figure.title), id);
  const std::string words = html::element("strong", html::text(figure.title + ".")) + html::text(figure.caption);
  markup_ += html::element("figure", plot + html::element("figcaption", words, fmt::format("id=\"{}-caption\"", id)));
  figures_.push_back(figure.data);
  figures_.back()["id"] = id;
}

}  // namespace artcal
