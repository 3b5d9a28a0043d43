#include "app/history/history_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/history/drift_sections.h"
#include "app/history/what_changed.h"
#include "app/report/numbers.h"
#include "app/report/page.h"
#include "app/report/sheet.h"
#include "app/results/verification/standard_name.h"
#include "app/version.h"

namespace artcal {
namespace {

using namespace numbers;

std::string shown_date(const HistoryEntry& entry) { return entry.date.empty() ? "no date" : shown(entry.date); }

std::string certificates_of(const HistoryEntry& entry) {
  return entry.certificates.empty() ? "none" : fmt::format("{}", fmt::join(entry.certificates, "; "));
}

void write_calibration_verdict(const ArmHistory& history, Sheet& sheet) {
  if (history.calibration_steps.empty()) {
    return;
  }
  const CalibrationStep& last = history.calibration_steps.back();
  const std::string since = shown_date(history.calibrations[last.then].entry);
  if (!last.not_comparable.empty()) {
    sheet.verdict(Mood::Unsure, "Parameters: not comparable",
                  fmt::format("Those of {} and of {} mean different things: {}.", since,
                              shown_date(history.calibrations[last.now].entry), last.not_comparable));
    return;
  }
  const auto& overall = history.calibrations_overall;
  const bool slowly = overall && overall->significant();
  const std::string lengths = lengths_in_words(last, "µm");
  std::string text = !last.significant() ? fmt::format("No significant change since {}. ", since)
                     : lengths.empty()   ? ""
                                         : fmt::format("The change since then moves {}. ", lengths);
  text += slowly ? fmt::format("Changed significantly since {}.", shown_date(history.calibrations[overall->then].entry))
                 : "";
  sheet.verdict(last.significant() || slowly ? Mood::Unsure : Mood::Good,
                last.significant() ? fmt::format("⚠ Parameters changed since {}", since)
                : slowly           ? "⚠ Parameters drift"
                                   : "✓ Parameters have not changed",
                text);
}

const VerificationStep* step_to(const std::vector<VerificationStep>& steps, std::size_t now) {
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const auto& step) { return step.now == now; });
  return found == steps.end() ? nullptr : &*found;
}

std::string since_in_words(const ArmHistory& history, const VerificationStep& step) {
  return fmt::format("Since {}: {}. ", shown_date(history.verifications[step.then].entry), change_in_words(step));
}

void write_verification_verdict(const ArmHistory& history, std::size_t index, Sheet& sheet) {
  const PastVerification& past = history.verifications[index];
  const VerificationStep* last = step_to(history.verification_steps, index);
  const VerificationStep* overall = step_to(history.verifications_overall, index);
  const bool changed =
      (last != nullptr && last->significant() > 0) || (overall != nullptr && overall->significant() > 0);
  const char* sign = past.conclusion == Conclusion::NonConformityProven ? "✗"
                     : past.conclusion == Conclusion::ConformityProven  ? "✓"
                                                                        : "–";
  sheet.verdict(past.conclusion == Conclusion::NonConformityProven            ? Mood::Bad
                : past.conclusion == Conclusion::ConformityProven && !changed ? Mood::Good
                                                                              : Mood::Unsure,
                fmt::format("{} {}, {}: {}", sign, standard_in_words(past.standard), shown_date(past.entry),
                            text_of(past.conclusion)),
                (last != nullptr ? since_in_words(history, *last) : "") +
                    (overall != nullptr ? since_in_words(history, *overall) : ""));
}

void write_verdicts(const ArmHistory& history, Sheet& sheet) {
  write_calibration_verdict(history, sheet);
  for (std::size_t i = 0; i < history.verifications.size(); ++i) {
    const bool is_last = std::none_of(
        history.verifications.begin() + static_cast<std::ptrdiff_t>(i) + 1, history.verifications.end(),
        [&](const PastVerification& later) { return later.standard == history.verifications[i].standard; });
    if (is_last) {
      write_verification_verdict(history, i, sheet);
    }
  }
}

// What a reader asks first.
void write_what_changed(const ArmHistory& history, Sheet& sheet) {
  std::vector<std::string> sentences;
  for (const ChangeSentence& sentence : what_changed(history, "µm")) {
    sentences.push_back((sentence.significant ? "⚠ " : "– ") + sentence.text);
  }
  if (sentences.empty()) {
    return;
  }
  sheet.part("What changed");
  sheet.list(sentences);
  html::Table table(
      "Changes of the parameters from one identification to the next, and what they change measured "
      "lengths by (500 lengths between random postures), µm",
      {{"date", false, true, true},
       {"since", false, false, true},
       {"largest", true, false, false, false, true},
       {"rms"},
       {"", false, false, false, false, true}});
  for (const CalibrationStep& step : history.calibration_steps) {
    const bool comparable = step.not_comparable.empty();
    table.add({day_of(history.calibrations[step.now].entry), day_of(history.calibrations[step.then].entry),
               step.lengths ? micrometres(step.lengths->maximum) : "not known",
               step.lengths ? micrometres(step.lengths->rms) : "not known",
               !comparable          ? "not comparable"
               : step.significant() ? "⚠ changed"
                                    : "within chance"});
  }
  sheet.table(table);
}

void write_what_was_done(const ArmHistory& history, Sheet& sheet) {
  html::Table calibrations("Identifications, rms in mm", {{"date", false, true, true},
                                                          {"recording", false},
                                                          {"before"},
                                                          {"after"},
                                                          {"artefacts and certificates", false}});
  for (const Calibration& calibration : history.calibrations) {
    calibrations.add({shown_date(calibration.entry), shown(calibration.entry.name),
                      calibration.rms_before ? mm(*calibration.rms_before) : "not evaluable", mm(calibration.rms_after),
                      certificates_of(calibration.entry)});
  }
  html::Table verifications("Verifications", {{"date", false, true, true},
                                              {"recording", false},
                                              {"standard", false},
                                              {"conclusion", false, false, false, false, true},
                                              {"artefacts and certificates", false}});
  for (const PastVerification& past : history.verifications) {
    verifications.add({shown_date(past.entry), shown(past.entry.name), standard_in_words(past.standard),
                       text_of(past.conclusion), certificates_of(past.entry)});
  }
  sheet.section("What was done");
  sheet.table(calibrations);
  sheet.table(verifications);
}

}  // namespace

std::string history_html(const ArmHistory& history, const std::string& store) {
  Sheet sheet;
  const std::string title = "History: " + shown(history.arm);
  sheet.title(title);
  write_what_changed(history, sheet);
  write_verdicts(history, sheet);
  write_parameter_drift(history, sheet);
  write_value_drift(history, sheet);
  write_what_was_done(history, sheet);
  sheet.note(fmt::format("From the store {} by artcal {}: the results that stand, of files as they are now.",
                         shown(store), program_version));
  return page_html({title, html::element("main", sheet.markup()), nlohmann::ordered_json{{"figures", sheet.figures()}},
                    Scripts::Plots, title});
}

}  // namespace artcal
