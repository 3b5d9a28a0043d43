#include "app/history/what_changed.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "app/results/verification/standard_name.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

std::string span_of(const HistoryEntry& then, const HistoryEntry& now) {
  return fmt::format("on {} (since {})", day_of(now), day_of(then));
}

// Significant before not, then by what measured lengths change.
bool is_smaller(const CalibrationStep& a, const CalibrationStep& b) {
  const auto rank = [](const CalibrationStep& step) {
    return std::tuple(step.not_comparable.empty(), step.not_comparable.empty() && step.significant(),
                      step.lengths ? step.lengths->maximum : 0.0, step.chi_squared);
  };
  return rank(a) < rank(b);
}

std::string counted(std::size_t significant, std::size_t all) {
  return fmt::format("{} of {} steps changed by more than chance explains", significant, all);
}

std::vector<ChangeSentence> parameters_changed(const ArmHistory& history, const char* micrometre) {
  const auto& steps = history.calibration_steps;
  if (steps.empty()) {
    return {};
  }
  const auto largest = std::max_element(steps.begin(), steps.end(), is_smaller);
  if (!largest->not_comparable.empty()) {
    return {{fmt::format("Parameters: no two identifications in a row are comparable{}.",
                         largest->lengths
                             ? fmt::format("; the largest change is of {} {}", lengths_in_words(*largest, micrometre),
                                           span_of(history.calibrations[largest->then].entry,
                                                   history.calibrations[largest->now].entry))
                             : ""),
             false}};
  }
  const auto significant = static_cast<std::size_t>(std::count_if(
      steps.begin(), steps.end(), [](const auto& step) { return step.not_comparable.empty() && step.significant(); }));
  const std::string lengths = lengths_in_words(*largest, micrometre);
  std::vector<ChangeSentence> sentences{
      {fmt::format("Parameters: {}{} {}; {}.",
                   significant > 0 ? "largest change" : "no significant change, the largest",
                   lengths.empty() ? "" : ", " + lengths + ",",
                   span_of(history.calibrations[largest->then].entry, history.calibrations[largest->now].entry),
                   counted(significant, steps.size())),
       significant > 0}};
  if (const auto& overall = history.calibrations_overall; overall && overall->significant()) {
    const std::string over_all = lengths_in_words(*overall, micrometre);
    sentences.push_back(
        {fmt::format("Parameters from {} to {}: changed by more than chance explains{}.",
                     day_of(history.calibrations[overall->then].entry),
                     day_of(history.calibrations[overall->now].entry), over_all.empty() ? "" : ", " + over_all),
         true});
  }
  return sentences;
}

bool is_length(const Drift& drift) { return !drift.second.empty(); }

std::string drift_in_words(const Drift& drift, const char* micrometre) {
  return fmt::format("{} {}, placement {}, by {:+.1f} {}", name_of(drift.quantity),
                     truncated(40, drift.second.empty() ? drift.first : drift.first + " - " + drift.second),
                     truncated(30, drift.placement), drift.drift / units::micrometre, micrometre);
}

ChangeSentence values_changed(const ArmHistory& history, const std::vector<const VerificationStep*>& steps,
                              const char* micrometre) {
  const VerificationStep* largest = nullptr;
  const auto rank = [](const VerificationStep& step) {
    const Drift* drift = largest_drift(step);
    return drift == nullptr ? std::tuple(false, false, 0.0)
                            : std::tuple(drift->significant, is_length(*drift), std::abs(drift->drift));
  };
  std::size_t significant = 0;
  for (const VerificationStep* step : steps) {
    largest = largest == nullptr || rank(*step) > rank(*largest) ? step : largest;
    significant += step->significant() > 0 ? 1 : 0;
  }
  const std::string standard = standard_in_words(history.verifications[largest->now].standard);
  const Drift* drift = largest_drift(*largest);
  if (drift == nullptr) {
    return {fmt::format("{}: no value is in two verifications in a row.", standard), false};
  }
  return {fmt::format("{}: {}, {}, {}; {}.", standard,
                      drift->significant ? "largest change" : "no significant change, the largest",
                      drift_in_words(*drift, micrometre),
                      span_of(history.verifications[largest->then].entry, history.verifications[largest->now].entry),
                      counted(significant, steps.size())),
          drift->significant};
}

}  // namespace

std::string day_of(const HistoryEntry& entry) {
  return entry.date.empty() ? "no date, recording " + in_quotes(entry.name) : truncated(40, entry.date);
}

std::string lengths_in_words(const CalibrationStep& step, const char* micrometre) {
  return step.lengths ? fmt::format("measured lengths by up to {:.1f} {}, {:.1f} {} rms",
                                    step.lengths->maximum / units::micrometre, micrometre,
                                    step.lengths->rms / units::micrometre, micrometre)
                      : std::string();
}

const Drift* largest_drift(const VerificationStep& step) {
  const auto rank = [](const Drift& drift) {
    return std::tuple(drift.significant, is_length(drift), std::abs(drift.drift));
  };
  const auto& drifts = step.check.drifts;
  const auto largest =
      std::max_element(drifts.begin(), drifts.end(), [&](const Drift& a, const Drift& b) { return rank(a) < rank(b); });
  return largest == drifts.end() ? nullptr : &*largest;
}

std::vector<ChangeSentence> what_changed(const ArmHistory& history, const char* micrometre) {
  std::vector<ChangeSentence> sentences = parameters_changed(history, micrometre);
  std::vector<std::string> standards;
  for (const PastVerification& past : history.verifications) {
    if (std::find(standards.begin(), standards.end(), past.standard) == standards.end()) {
      standards.push_back(past.standard);
    }
  }
  for (const std::string& standard : standards) {
    std::vector<const VerificationStep*> steps;
    for (const VerificationStep& step : history.verification_steps) {
      if (history.verifications[step.now].standard == standard) {
        steps.push_back(&step);
      }
    }
    if (!steps.empty()) {
      sentences.push_back(values_changed(history, steps, micrometre));
    }
  }
  return sentences;
}

}  // namespace artcal
