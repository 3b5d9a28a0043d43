#include "app/history/recall/certificate_list.h"

#include <fmt/format.h>

#include "app/output/table.h"
#include "app/output/text_or_null.h"
#include "app/report/numbers.h"
#include "app/report/page.h"
#include "app/report/sheet.h"
#include "app/results/result_head.h"
#include "app/store/stored_text.h"
#include "app/version.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// A store may hold texts that other programs wrote.
nlohmann::ordered_json valid_or_null(const std::string& text) { return text_or_null(valid_utf8(text)); }

std::string cell(const nlohmann::ordered_json& value, const char* where_none) {
  return value.is_null() ? where_none : numbers::shown(value.get<std::string>());
}

}  // namespace

std::string to_text(const std::string& certificate, const std::vector<CertificateUse>& uses) {
  Table table({"arm", "date", "recording", "artefact", "laboratory", "file"});
  for (const CertificateUse& use : uses) {
    table.add({truncated(40, use.arm), use.date.empty() ? "no date" : use.date, truncated(40, use.name),
               truncated(40, use.artefact), truncated(40, use.laboratory),
               use.path.empty() ? "no longer there" : in_one_line(use.path)});
  }
  return fmt::format("Results that rest on certificate {}: {}\n\n{}", in_quotes(certificate), uses.size(),
                     table.text());
}

nlohmann::ordered_json to_json(const std::string& certificate, const std::vector<CertificateUse>& uses,
                               const std::string& store) {
  nlohmann::ordered_json json = result_head("certificate-uses");
  json["store"] = store;
  json["certificate"] = certificate;
  json["results"] = nlohmann::ordered_json::array();
  for (const CertificateUse& use : uses) {
    json["results"].push_back({{"arm", valid_or_null(use.arm)},
                               {"date", valid_or_null(use.date)},
                               {"recording", valid_or_null(use.name)},
                               {"artefact", valid_or_null(use.artefact)},
                               {"laboratory", valid_or_null(use.laboratory)},
                               {"file", valid_or_null(use.path)}});
  }
  return json;
}

std::string certificate_page(const nlohmann::ordered_json& list) {
  const auto& results = list.at("results");
  Sheet sheet;
  const std::string title = "Results that rest on certificate " + numbers::shown(list.at("certificate"));
  sheet.title(title);
  html::Table table(fmt::format("{} results, by arm and date", results.size()), {{"arm", false, true},
                                                                                 {"date", false, false, true},
                                                                                 {"recording", false},
                                                                                 {"artefact", false},
                                                                                 {"laboratory", false},
                                                                                 {"file", false}});
  for (const auto& result : results) {
    table.add({cell(result.at("arm"), ""), cell(result.at("date"), "no date"), cell(result.at("recording"), ""),
               cell(result.at("artefact"), ""), cell(result.at("laboratory"), ""),
               cell(result.at("file"), "no longer there")});
  }
  sheet.table(table);
  sheet.note(fmt::format("From the store {} by artcal {}.", numbers::shown(list.at("store")), program_version));
  return page_html(
      {title, html::element("main", sheet.markup()), nlohmann::ordered_json::object(), Scripts::Sorting, title});
}

}  // namespace artcal
