#include "app/report/report.h"

#include <exception>

#include <fmt/format.h>

#include "app/report/identification_section.h"
#include "app/report/numbers.h"
#include "app/report/page.h"
#include "app/report/provenance.h"
#include "app/version.h"
#include "core/in_quotes.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

std::string arm_of(const ReportedResult& result) { return result.json.at("arm").get<std::string>(); }

std::string heading_of(const ReportedResult& result) {
  return fmt::format("Identification: {}", numbers::shown(numbers::text_in(result.json, "recording")));
}

void write_result(const ReportedResult& result, Sheet& sheet) {
  sheet.section(heading_of(result));
  write_circumstances(result.json, sheet);
  write_identification(result.json, sheet);
}

}  // namespace

Expected<std::string> report_html(const std::vector<ReportedResult>& results) {
  const ReportedResult* current = nullptr;
  try {
    Sheet sheet;
    const std::string title = fmt::format("Calibration report: {}", numbers::shown(arm_of(results.front())));
    sheet.title(title);
    for (const ReportedResult& result : results) {
      current = &result;
      if (arm_of(result) != arm_of(results.front())) {
        return wrong_usage(fmt::format("a report is of one arm, but {} is of {} and {} is of {}",
                                       in_quotes(results.front().path), in_quotes(arm_of(results.front())),
                                       in_quotes(result.path), in_quotes(arm_of(result))));
      }
      write_identification_verdict(result.json, sheet);
    }
    for (const ReportedResult& result : results) {
      current = &result;
      write_result(result, sheet);
    }
    write_provenance(results, sheet);
    const std::string body = html::element("main", sheet.markup());
    return page_html({title, body, Json{{"figures", sheet.figures()}}, Scripts::Plots});
  } catch (const std::exception&) {
    return bad_input(
        "this result lacks what every result of its kind has, or holds something else there; expected it as "
        "--json wrote it",
        current == nullptr ? std::string() : current->path);
  }
}

}  // namespace artcal
