#include "app/history/history_text.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/history/over_time.h"
#include "app/history/what_changed.h"
#include "app/output/table.h"
#include "app/results/shown_text.h"
#include "app/results/shown_unit.h"
#include "app/results/verification/standard_name.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

std::string date_of(const HistoryEntry& entry) { return entry.date.empty() ? "no date" : entry.date; }

std::string listed(const std::vector<std::string>& texts) {
  return texts.empty() ? std::string("none") : fmt::format("{}", fmt::join(texts, "; "));
}

std::string in_common_text(const std::vector<std::string>& certificates) {
  if (certificates.empty()) {
    return "  No certificate is common to both.\n";
  }
  return fmt::format("  Common to both: {}.\n", listed(certificates));
}

std::string calibrations_text(const ArmHistory& history) {
  Table table({"calibration", "recording", "rms before mm", "rms after mm", "certificates"});
  for (const Calibration& calibration : history.calibrations) {
    table.add({date_of(calibration.entry), truncated(40, calibration.entry.name),
               calibration.rms_before ? fmt::format("{:.4f}", *calibration.rms_before) : std::string("not evaluable"),
               fmt::format("{:.4f}", calibration.rms_after), listed(calibration.entry.certificates)});
  }
  return table.text();
}

// The value of largest size of each quantity, in the order of the quantities.
std::string largest_text(const std::vector<TestValue>& values) {
  std::map<Quantity, double> largest;
  for (const TestValue& value : values) {
    if (!value.set_aside) {
      double& most = largest[value.quantity];
      most = std::abs(value.value) > std::abs(most) ? value.value : most;
    }
  }
  std::vector<std::string> texts;
  for (const auto& [quantity, value] : largest) {
    texts.push_back(fmt::format("{} {}", name_of(quantity), deviation_text(value, is_signed(quantity))));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string verifications_text(const ArmHistory& history) {
  Table table({"verification", "standard", "conclusion", "largest, mm", "certificates"});
  for (const PastVerification& verification : history.verifications) {
    table.add({date_of(verification.entry), standard_in_words(verification.standard), text_of(verification.conclusion),
               largest_text(verification.values), listed(verification.entry.certificates)});
  }
  return table.text();
}

std::string step_text(const ArmHistory& history, const CalibrationStep& step, bool all) {
  std::string text = fmt::format("\nParameters from {} to {}: ", date_of(history.calibrations[step.then].entry),
                                 date_of(history.calibrations[step.now].entry));
  if (!step.not_comparable.empty()) {
    return text + "not comparable, " + step.not_comparable + "\n";
  }
  const std::string lengths = lengths_in_words(step, "um");
  const std::string changed = "CHANGED" + (lengths.empty() ? "" : ", " + lengths);
  text += fmt::format("{} (chi squared {:.4g} of all {} together, chance stays below {:.4g})\n",
                      step.significant() ? changed : "no significant change", step.chi_squared, step.changes.size(),
                      step.limit);
  if (!step.moved.empty()) {
    text += fmt::format(
        "  {} was fixed at another value, and no reading sees the difference: the later parameters are stated as they\n"
        "  are where it has the earlier one.\n",
        fmt::join(step.moved, ", "));
  }
  Table table({"  parameter", "unit", "then", "now", "change", "u (k = 1)", ""});
  bool any = false;
  for (const ParameterChange& change : step.changes) {
    if (all || change.significant) {
      any = true;
      const ShownUnit as = shown_unit(change.name, change.unit);
      table.add({"  " + change.name, as.name, fmt::format("{:.{}f}", change.then / as.size, as.decimals),
                 fmt::format("{:.{}f}", change.now / as.size, as.decimals),
                 fmt::format("{:+.2g}", (change.now - change.then) / as.size),
                 fmt::format("{:.2g}", change.u / as.size), change.significant ? "significant" : ""});
    }
  }
  text += any ? table.text() : "  No parameter by itself changed significantly.\n";
  return text + in_common_text(step.in_common);
}

std::string step_text(const ArmHistory& history, const VerificationStep& step, bool all) {
  const auto& drifts = step.check.drifts;
  std::string text =
      fmt::format("\n{} from {} to {}: {}\n", standard_in_words(history.verifications[step.now].standard),
                  date_of(history.verifications[step.then].entry), date_of(history.verifications[step.now].entry),
                  change_in_words(step));
  Table table({"  value", "then mm", "now mm", "change mm", "u mm", ""});
  bool any = false;
  for (const Drift& drift : drifts) {
    if (all || drift.significant) {
      any = true;
      const std::string between = drift.second.empty() ? drift.first : drift.first + " - " + drift.second;
      table.add({fmt::format("  {} {}, placement {}", name_of(drift.quantity), truncated(40, between),
                             truncated(20, drift.placement)),
                 deviation_text(drift.then, is_signed(drift.quantity)),
                 deviation_text(drift.now, is_signed(drift.quantity)), signed_mm_text(drift.drift),
                 fmt::format("{:.4f}", drift.u), drift.significant ? "significant" : ""});
    }
  }
  return text + (any ? table.text() : "") + in_common_text(step.in_common);
}

std::string worst_text(const ArmHistory& history) {
  Table table({"  worst of a quantity", "when", "mm", "u (k = 1) mm", "limit mm", "verdict"});
  bool any = false;
  for (const WorstOverTime& worst : worst_over_time(history)) {
    for (const auto& [verification, value] : worst.points) {
      any = any || worst.points.size() > 1;
      table.add({fmt::format("  {} {}", standard_in_words(worst.standard), name_of(worst.quantity)),
                 date_of(history.verifications[verification].entry),
                 deviation_text(value->value, is_signed(worst.quantity)), fmt::format("{:.4f}", value->budget.total()),
                 value->limit ? fmt::format("{:.4f}", *value->limit) : std::string("none"), text_of(value->verdict)});
    }
  }
  return any ? "\nValues over time\n" + table.text() : "";
}

// What a reader asks first.
std::string changed_text(const ArmHistory& history) {
  const auto sentences = what_changed(history, "um");
  if (sentences.empty()) {
    return "";
  }
  std::string text = "What changed\n";
  for (const ChangeSentence& sentence : sentences) {
    text += fmt::format("  {} {}\n", sentence.significant ? "!" : "-", sentence.text);
  }
  Table table({"  parameters on", "since", "lengths, um: up to", "rms", ""});
  for (const CalibrationStep& step : history.calibration_steps) {
    const auto micrometres = [&](double LengthChange::*size) {
      return step.lengths ? fmt::format("{:.1f}", *step.lengths.*size / units::micrometre) : std::string("not known");
    };
    table.add({"  " + day_of(history.calibrations[step.now].entry), day_of(history.calibrations[step.then].entry),
               micrometres(&LengthChange::maximum), micrometres(&LengthChange::rms),
               !step.not_comparable.empty() ? "not comparable"
               : step.significant()         ? "changed"
                                            : "within chance"});
  }
  const bool several = history.calibration_steps.size() > 1;
  return text + (several ? "\n" + table.text() : "") + "\n";
}

template <typename Steps>
bool any_in_common(const Steps& steps) {
  return std::any_of(steps.begin(), steps.end(), [](const auto& step) { return !step.in_common.empty(); });
}

}  // namespace

std::string to_text(const ArmHistory& history, bool all) {
  std::string text = fmt::format("arm {}\n\n", in_quotes(history.arm)) + changed_text(history);
  if (!history.calibrations.empty()) {
    text += calibrations_text(history);
  }
  if (!history.verifications.empty()) {
    text += (history.calibrations.empty() ? "" : "\n") + verifications_text(history);
  }
  text += worst_text(history);
  for (const CalibrationStep& step : history.calibration_steps) {
    text += step_text(history, step, all);
  }
  for (const VerificationStep& step : history.verification_steps) {
    text += step_text(history, step, all);
  }
  if (history.calibrations_overall || !history.verifications_overall.empty()) {
    text += "\nOver all, because a slow drift may be significant in no single step:\n";
  }
  if (history.calibrations_overall) {
    text += step_text(history, *history.calibrations_overall, all);
  }
  for (const VerificationStep& step : history.verifications_overall) {
    text += step_text(history, step, all);
  }
  if (any_in_common(history.calibration_steps)) {
    text +=
        "\nThe uncertainty of an artefact that two calibrations have in common mostly cancels in a change of "
        "parameters; here\nit is counted twice, so that the u of changes are rather too large: what is called "
        "significant is.\n";
  }
  if (any_in_common(history.verification_steps)) {
    text +=
        "\nWhat the certified values of an artefact in common are off by is the same in both verifications and is left "
        "out of\nthe u of changes of values.\n";
  }
  return text;
}

}  // namespace artcal
