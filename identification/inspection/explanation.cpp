#include "identification/inspection/explanation.h"

#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "identification/inspection/mistake_search.h"

namespace artcal {
namespace {

constexpr std::size_t max_readings = 1500;

// A recording with so many readings that fits are quick, evenly taken from each feature.
Recording thinned(const Recording& recording) {
  if (recording.readings.size() <= max_readings) {
    return recording;
  }
  const auto step = static_cast<int>((recording.readings.size() + max_readings - 1) / max_readings);
  std::map<std::tuple<int, int, int>, int> counts;
  std::vector<bool> kept(recording.readings.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Reading& reading = recording.readings[i];
    const int count = counts[{reading.artefact, reading.placement, reading.feature}]++;
    kept[i] = count % step == 0 || count < 6;
  }
  return readings_where(recording, [&](int i) { return kept[static_cast<std::size_t>(i)]; });
}

using Run = void (MistakeSearch::*)();

Explanation explained_of(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                         const AsWritten& as_written, Run run) {
  MistakeSearch first(recording, constraints, options, as_written);
  (first.*run)();
  Explanation explanation = first.explanation();
  const bool is_named = !explanation.findings.empty();
  const auto remainder = is_named ? first.remainder() : first.remainder_by_nominal();
  if (!remainder) {
    return explanation;
  }
  MistakeSearch second(remainder->bound.recording, remainder->bound.constraints, remainder->options,
                       remainder->as_written);
  (second.*run)();
  if (Explanation further = second.explanation(); !further.findings.empty()) {
    explanation.findings = {remainder->found, std::move(further.findings.front())};
  } else if (is_named) {
    explanation.findings.front().text += fmt::format(
        ". The {:.2g} mm that are left are more than a sound recording leaves: there is a second mistake, or "
        "the arm has unmodelled errors",
        remainder->as_written.size);
  }
  return explanation;
}

Explanation explained(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                      const AsWritten& as_written, Run run) {
  const Recording fewer = thinned(recording);
  if (fewer.readings.size() == recording.readings.size()) {
    return explained_of(recording, constraints, options, as_written, run);
  }
  const auto own = build_constraints(fewer, constraints.artefacts);
  return own ? explained_of(fewer, *own, options, as_written, run) : Explanation{};
}

}  // namespace

Explanation explain(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                    const AsWritten& as_written) {
  return explained(recording, constraints, options, as_written, &MistakeSearch::run);
}

Explanation explain_by_radii(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                             const AsWritten& as_written) {
  return explained(recording, constraints, options, as_written, &MistakeSearch::run_radii);
}

}  // namespace artcal
