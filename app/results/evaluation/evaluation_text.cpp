#include "app/results/evaluation/evaluation_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/output/table.h"
#include "app/results/shown_text.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t max_lengths_listed = 20;
constexpr std::size_t max_readings = 5;

std::string placement_name(const FeatureName& name, bool several_artefacts) {
  return several_artefacts ? shown_name(name.artefact) + ", " + shown_name(name.placement) : shown_name(name.placement);
}

std::string placements_text(const Evaluation& evaluation) {
  const bool several_artefacts = evaluation.artefacts.size() > 1;
  Table table({"placement", "readings", "rms, mm", "largest, mm"});
  for (const FeatureDeviation& placement : evaluation.placements) {
    table.add({placement_name(placement.name, several_artefacts), fmt::format("{}", placement.readings),
               mm_text(placement.rms), mm_text(placement.maximum)});
  }
  table.add({"all", fmt::format("{}", evaluation.overall.readings), mm_text(evaluation.overall.rms),
             mm_text(evaluation.overall.maximum)});
  return table.text() + "\n";
}

std::string lengths_text(const Evaluation& evaluation) {
  if (evaluation.lengths.empty()) {
    return {};
  }
  std::vector<LengthDeviation> worst_first = evaluation.lengths;
  std::stable_sort(worst_first.begin(), worst_first.end(),
                   [](const auto& a, const auto& b) { return std::abs(a.error) > std::abs(b.error); });
  Table table({"certified length, the worst first", "at temperature, mm", "error, mm"});
  for (std::size_t i = 0; i < std::min(max_lengths_listed, worst_first.size()); ++i) {
    const LengthDeviation& length = worst_first[i];
    table.add({fmt::format("{} {} - {}", shown_name(length.first.placement), shown_name(length.first.feature),
                           shown_name(length.second)),
               mm_text(length.at_temperature), signed_mm_text(length.error)});
  }
  const std::size_t more = worst_first.size() - std::min(max_lengths_listed, worst_first.size());
  return table.text() + (more > 0 ? fmt::format("  and {} more\n\n", more) : "\n");
}

std::string readings_text(const Recording& recording, const Constraints& constraints, const Evaluation& evaluation) {
  struct OfReading {
    int reading;
    double deviation;
    bool is_signed;
  };
  std::vector<OfReading> worst_first;
  for (const FeatureConstraint& feature : constraints.features) {
    for (const int reading : feature.readings) {
      worst_first.push_back({reading, evaluation.deviations[worst_first.size()], has_signed_deviation(feature)});
    }
  }
  std::stable_sort(worst_first.begin(), worst_first.end(),
                   [](const auto& a, const auto& b) { return std::abs(a.deviation) > std::abs(b.deviation); });
  std::string text = "Largest deviations of single readings:\n";
  for (std::size_t i = 0; i < std::min(max_readings, worst_first.size()); ++i) {
    const auto& [reading, deviation, is_signed] = worst_first[i];
    text += fmt::format("  {}: {} mm\n", recording.where(reading), deviation_text(deviation, is_signed));
  }
  return text;
}

}  // namespace

std::string to_text(const Recording& recording, const Constraints& constraints, const Evaluation& evaluation,
                    const std::vector<std::string>& warnings) {
  return fmt::format("{}\nevaluated with the arm {}: {}, {}, {}\n\n{}{}{}{}", shown_name(recording.name),
                     in_quotes(recording.arm.name), plural(recording.readings.size(), "reading"),
                     plural(constraints.features.size(), "feature"), plural(evaluation.placements.size(), "placement"),
                     warning_lines(warnings) + (warnings.empty() ? "" : "\n"), placements_text(evaluation),
                     lengths_text(evaluation), readings_text(recording, constraints, evaluation));
}

}  // namespace artcal
