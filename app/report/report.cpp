#include "app/report/report.h"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "app/report/numbers.h"
#include "app/report/over_time/drift.h"
#include "app/report/sections/identification_section.h"
#include "app/report/sections/monte_carlo_section.h"
#include "app/report/sections/provenance.h"
#include "app/report/sections/uncertainty_section.h"
#include "app/report/sections/verification_section.h"
#include "core/overloaded.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

std::string heading_of(const RecordedResult& result) {
  const std::string name = numbers::shown(result.head.recording);
  return std::visit(
      Overloaded{[&](const RecordedIdentification&) { return "Identification: " + name; },
                 [&](const RecordedVerification&) { return "Verification: " + name; },
                 [&](const RecordedMonteCarlo&) { return "Monte Carlo: " + name; },
                 [](const RecordedUncertainty&) -> std::string { return "What the identified arm measures like"; }},
      result.content);
}

bool has_verdict(const RecordedResult& result) { return !std::holds_alternative<RecordedUncertainty>(result.content); }

void write_verdict(const RecordedResult& result, Sheet& sheet) {
  std::visit(Overloaded{[&](const RecordedIdentification& found) { write_identification_verdict(found, sheet); },
                        [&](const RecordedVerification& found) { write_verification_verdict(found, sheet); },
                        [&](const RecordedMonteCarlo& found) { write_monte_carlo_verdict(found, sheet); },
                        [](const RecordedUncertainty&) {}},
             result.content);
}

void write_result(const RecordedResult& result, Sheet& sheet) {
  sheet.section(heading_of(result));
  std::visit(Overloaded{[&](const RecordedIdentification& found) {
                          write_circumstances(result.head, found.circumstances, sheet);
                          write_identification(found, sheet);
                        },
                        [&](const RecordedVerification& found) {
                          write_circumstances(result.head, found.circumstances, sheet);
                          write_verification(found, sheet);
                        },
                        [&](const RecordedMonteCarlo& found) { write_monte_carlo(result.head, found, sheet); },
                        [&](const RecordedUncertainty& found) { write_uncertainty(found, sheet); }},
             result.content);
}

// A verdict alone says too little where there are several.
std::string told_apart(const RecordedResult& result) {
  const std::string& date = result.head.date;
  return heading_of(result) + (date.empty() ? "" : ", " + numbers::shown(date));
}

Expected<std::vector<RecordedResult>> of_one_arm(const std::vector<ReportedResult>& results) {
  std::vector<RecordedResult> all;
  for (const ReportedResult& result : results) {
    auto read = recorded_result(result);
    if (!read) {
      return tl::unexpected(read.error());
    }
    all.push_back(std::move(*read));
    const RecordedResult& first = all.front();
    if (all.back().head.arm != first.head.arm) {
      return wrong_usage(fmt::format("a report is of one arm, but {} is of {} and {} is of {}", in_quotes(first.path),
                                     in_quotes(first.head.arm), in_quotes(result.path),
                                     in_quotes(all.back().head.arm)));
    }
  }
  return all;
}

}  // namespace

Expected<std::string> report_html(const std::vector<ReportedResult>& results, Scripts plots) {
  const auto all = of_one_arm(results);
  if (!all) {
    return tl::unexpected(all.error());
  }
  Sheet sheet;
  const std::string title = "Calibration report: " + numbers::shown(all->front().head.arm);
  sheet.title(title);
  const auto judged = std::count_if(all->begin(), all->end(), has_verdict);
  for (const RecordedResult& result : *all) {
    if (judged > 1 && has_verdict(result)) {
      sheet.part(told_apart(result));
    }
    write_verdict(result, sheet);
  }
  for (const RecordedResult& result : *all) {
    write_result(result, sheet);
  }
  write_drift(*all, sheet);
  write_provenance(*all, sheet);
  const std::string body = html::element("main", sheet.markup());
  return page_html({title, body, nlohmann::ordered_json{{"figures", sheet.figures()}}, plots, title});
}

}  // namespace artcal
