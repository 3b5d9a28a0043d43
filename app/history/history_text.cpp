#include "app/history/history_text.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/table.h"
#include "core/in_quotes.h"

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
    table.add({date_of(calibration.entry), at_most(40, calibration.entry.name),
               fmt::format("{:.4f}", calibration.rms_before), fmt::format("{:.4f}", calibration.rms_after),
               listed(calibration.entry.certificates)});
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
    texts.push_back(fmt::format("{} {:+.4f}", name_of(quantity), value));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string verifications_text(const ArmHistory& history) {
  Table table({"verification", "standard", "conclusion", "largest, mm", "certificates"});
  for (const PastVerification& verification : history.verifications) {
    std::string conclusion = verification.conclusion;
    std::replace(conclusion.begin(), conclusion.end(), '_', ' ');
    table.add({date_of(verification.entry), verification.standard, conclusion, largest_text(verification.values),
               listed(verification.entry.certificates)});
  }
  return table.text();
}

std::string step_text(const ArmHistory& history, const CalibrationStep& step, bool all) {
  std::string text = fmt::format("\nParameters from {} to {}: ", date_of(history.calibrations[step.then].entry),
                                 date_of(history.calibrations[step.now].entry));
  if (!step.not_comparable.empty()) {
    return text + "not comparable, " + step.not_comparable + "\n";
  }
  text += fmt::format("{} (chi squared {:.4g} of all {} together, chance stays below {:.4g})\n",
                      step.significant() ? "CHANGED" : "no significant change", step.chi_squared, step.changes.size(),
                      step.limit);
  Table table({"  parameter", "unit", "then", "now", "change", "u (k = 1)", ""});
  bool any = false;
  for (const ParameterChange& change : step.changes) {
    if (all || change.significant) {
      any = true;
      table.add({"  " + change.name, change.unit, fmt::format("{:.6f}", change.then), fmt::format("{:.6f}", change.now),
                 fmt::format("{:+.2g}", change.now - change.then), fmt::format("{:.2g}", change.u),
                 change.significant ? "beyond 2 u" : ""});
    }
  }
  text += any ? table.text() : "  No parameter by itself changed by more than 2 u.\n";
  text += in_common_text(step.in_common);
  if (!step.in_common.empty()) {
    text +=
        "  Their uncertainty is in both alike and mostly cancels in a change; here it is counted twice, so that the\n"
        "  u of changes are rather too large: what is called significant is.\n";
  }
  return text;
}

std::string step_text(const ArmHistory& history, const VerificationStep& step, bool all) {
  const auto& drifts = step.check.drifts;
  const auto significant =
      std::count_if(drifts.begin(), drifts.end(), [](const Drift& drift) { return drift.significant; });
  std::string text =
      fmt::format("\n{} from {} to {}: {}\n", history.verifications[step.now].standard,
                  date_of(history.verifications[step.then].entry), date_of(history.verifications[step.now].entry),
                  drifts.empty()           ? "no value is in both"
                  : !step.check.any_told() ? "without repeats nothing can be called significant"
                  : significant > 0        ? fmt::format("{} of {} values CHANGED", significant, drifts.size())
                                           : fmt::format("no significant change of {} values", drifts.size()));
  Table table({"  value", "then mm", "now mm", "change mm", "u mm", ""});
  bool any = false;
  for (const Drift& drift : drifts) {
    if (all || drift.significant) {
      any = true;
      const std::string between = drift.second.empty() ? drift.first : drift.first + " - " + drift.second;
      table.add({fmt::format("  {} {}, placement {}", name_of(drift.quantity), at_most(40, between),
                             at_most(20, drift.placement)),
                 fmt::format("{:+.4f}", drift.then), fmt::format("{:+.4f}", drift.now),
                 fmt::format("{:+.4f}", drift.drift), fmt::format("{:.4f}", drift.u),
                 drift.significant ? "significant" : ""});
    }
  }
  return text + (any ? table.text() : "") + in_common_text(step.in_common) +
         (step.in_common.empty() ? ""
                                 : "  What its certified values are off by is in both alike and is left out of u.\n");
}

}  // namespace

std::string to_text(const ArmHistory& history, bool all) {
  std::string text = fmt::format("arm {}\n\n", in_quotes(history.arm));
  if (!history.calibrations.empty()) {
    text += calibrations_text(history);
  }
  if (!history.verifications.empty()) {
    text += (history.calibrations.empty() ? "" : "\n") + verifications_text(history);
  }
  for (const CalibrationStep& step : history.calibration_steps) {
    text += step_text(history, step, all);
  }
  for (const VerificationStep& step : history.verification_steps) {
    text += step_text(history, step, all);
  }
  return text;
}

}  // namespace artcal
