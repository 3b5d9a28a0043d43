#include "app/report/report.h"

#include <algorithm>
#include <exception>

#include <fmt/format.h>

#include "app/report/numbers.h"
#include "app/report/over_time/drift.h"
#include "app/report/sections/identification_section.h"
#include "app/report/sections/monte_carlo_section.h"
#include "app/report/sections/provenance.h"
#include "app/report/sections/uncertainty_section.h"
#include "app/report/sections/verification_section.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

std::string arm_name_of(const ReportedResult& result) { return result.json.at("arm").get<std::string>(); }

std::string heading_of(const ReportedResult& result) {
  const std::string name = numbers::shown(numbers::text_in(result.json, "recording"));
  switch (result.kind) {
    case ResultKind::Identification: return "Identification: " + name;
    case ResultKind::Verification: return "Verification: " + name;
    case ResultKind::MonteCarlo: return "Monte Carlo: " + name;
    case ResultKind::Uncertainty: break;
  }
  return "What the identified arm measures like";
}

bool has_verdict(const ReportedResult& result) { return result.kind != ResultKind::Uncertainty; }

void write_verdict(const ReportedResult& result, Sheet& sheet) {
  if (result.kind == ResultKind::Identification) {
    write_identification_verdict(result.json, sheet);
  } else if (result.kind == ResultKind::Verification) {
    write_verification_verdict(result.json, sheet);
  } else if (result.kind == ResultKind::MonteCarlo) {
    write_monte_carlo_verdict(result.json, sheet);
  }
}

void write_result(const ReportedResult& result, Sheet& sheet) {
  sheet.section(heading_of(result));
  switch (result.kind) {
    case ResultKind::Identification:
      write_circumstances(result.json, sheet);
      write_identification(result.json, sheet);
      break;
    case ResultKind::Verification:
      write_circumstances(result.json, sheet);
      write_verification(result.json, sheet);
      break;
    case ResultKind::MonteCarlo: write_monte_carlo(result.json, sheet); break;
    case ResultKind::Uncertainty: write_uncertainty(result.json, sheet); break;
  }
}

// A verdict alone says too little where there are several.
std::string told_apart(const ReportedResult& result) {
  const std::string date = numbers::text_in(result.json, "date");
  return heading_of(result) + (date.empty() ? "" : ", " + numbers::shown(date));
}

}  // namespace

Expected<std::string> report_html(const std::vector<ReportedResult>& results, Scripts plots) {
  const ReportedResult* current = nullptr;
  try {
    Sheet sheet;
    const std::string title = fmt::format("Calibration report: {}", numbers::shown(arm_name_of(results.front())));
    sheet.title(title);
    const auto judged = std::count_if(results.begin(), results.end(), has_verdict);
    for (const ReportedResult& result : results) {
      current = &result;
      if (arm_name_of(result) != arm_name_of(results.front())) {
        return wrong_usage(fmt::format("a report is of one arm, but {} is of {} and {} is of {}",
                                       in_quotes(results.front().path), in_quotes(arm_name_of(results.front())),
                                       in_quotes(result.path), in_quotes(arm_name_of(result))));
      }
      if (judged > 1 && has_verdict(result)) {
        sheet.part(told_apart(result));
      }
      write_verdict(result, sheet);
    }
    for (const ReportedResult& result : results) {
      current = &result;
      write_result(result, sheet);
    }
    current = nullptr;
    write_drift(results, sheet);
    write_provenance(results, sheet);
    const std::string body = html::element("main", sheet.markup());
    return page_html({title, body, Json{{"figures", sheet.figures()}}, plots, title});
  } catch (const std::exception&) {
    return bad_input(
        "this result lacks what every result of its kind has, or holds something else there; expected it as "
        "--json wrote it",
        current == nullptr ? std::string() : current->path);
  }
}

}  // namespace artcal
