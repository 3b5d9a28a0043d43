#include "app/report/batch_index.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/report/html.h"
#include "app/report/page.h"

namespace artcal {
namespace {

const char* word_of(IndexOutcome outcome) {
  switch (outcome) {
    case IndexOutcome::Failed: return "✗ failed";
    case IndexOutcome::NotShown: return "– not shown";
    case IndexOutcome::Done: break;
  }
  return "✓ done";
}

// Paths become links: what a URL would read otherwise than as a path is written as %XX.
std::string link_to(const std::string& path) {
  static constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string link = path.find(':') == std::string::npos ? "" : "./";  // no path is a scheme
  for (const char c : path) {
    link += plain.find(c) != std::string_view::npos ? std::string(1, c)
                                                    : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return link;
}

std::string number(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "";
}

// What all paths begin with, up to a slash: said once, not in every row.
std::string common_folder(const std::vector<IndexRow>& rows) {
  std::string common = rows.empty() ? "" : rows.front().recording;
  for (const IndexRow& row : rows) {
    const auto end = std::mismatch(common.begin(), common.end(), row.recording.begin(), row.recording.end()).first;
    common.erase(end, common.end());
  }
  const std::size_t slash = common.rfind('/');
  return slash == std::string::npos ? "" : common.substr(0, slash + 1);
}

std::string name_of(const IndexRow& row, const std::string& folder) {
  const std::string name = html::cell(std::string_view(row.recording).substr(folder.size()));
  return row.report.empty() ? name : fmt::format("<a href=\"{}\">{}</a>", link_to(row.report), name);
}

std::string summary(const std::vector<IndexRow>& rows) {
  const auto count = [&](IndexOutcome outcome) {
    return std::count_if(rows.begin(), rows.end(), [&](const IndexRow& row) { return row.outcome == outcome; });
  };
  return html::element(
      "p",
      fmt::format("{} recordings: {} done, {} with conformity not shown, {} failed.", rows.size(),
                  count(IndexOutcome::Done), count(IndexOutcome::NotShown), count(IndexOutcome::Failed)),
      "class=\"verdict\"");
}

}  // namespace

std::string index_html(const std::string& title, const std::vector<IndexRow>& rows) {
  std::vector<const IndexRow*> order;
  for (const IndexRow& row : rows) {
    order.push_back(&row);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) { return a->outcome > b->outcome; });
  const std::string folder = common_folder(rows);
  html::Table table("Every recording; a click on a column's head sorts by it",
                    {{"recording", false, true},
                     {"arm", false},
                     {"date", false, false, true},
                     {"task", false},
                     {"outcome", false, false, true, false, true},
                     {"rms before, mm"},
                     {"after, mm"},
                     {"largest / limit", true, false, false, false, true},
                     {"warnings"},
                     {"message", false}});
  for (const IndexRow* row : order) {
    table.add_markup(
        {name_of(*row, folder), html::cell(row->arm), html::cell(row->date), html::cell(row->task),
         word_of(row->outcome), number(row->rms_before, "{:.4f}"), number(row->rms_after, "{:.4f}"),
         number(row->largest_of_limit, "{:.2f}"), fmt::format("{}", row->warnings), html::cell(row->message)},
        row->outcome == IndexOutcome::Failed ? "notable" : "");
  }
  const std::string body =
      html::element("main",
                    html::element("h1", html::text(title)) + summary(rows) +
                        (folder.empty() ? "" : html::element("p", "Recordings in " + html::text(folder))) +
                        table.markup("class=\"sortable\""),
                    "class=\"wide\"");
  return page_html({title, body, nlohmann::ordered_json::object(), Scripts::Sorting, title});
}

}  // namespace artcal
