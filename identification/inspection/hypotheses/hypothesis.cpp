#include "identification/inspection/hypotheses/hypothesis.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "identification/evaluation/evaluation.h"

namespace artcal {

std::optional<Bound> applied(const Hypothesis& hypothesis, const Recording& recording,
                             const std::vector<Artefact>& artefacts) {
  Recording changed = recording;
  std::vector<Artefact> certified = artefacts;
  hypothesis.apply(changed, certified);
  if (changed.readings.empty()) {
    return std::nullopt;
  }
  auto constraints = build_constraints(changed, std::move(certified));
  return constraints ? std::optional(Bound{std::move(changed), std::move(*constraints)}) : std::nullopt;
}

double discrepancy(const Bound& bound, const Arm& arm) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const auto evaluation = evaluate(bound.recording, bound.constraints, arm);
  if (!evaluation) {
    return none;
  }
  double squares = 0.0;
  for (const LengthDeviation& length : evaluation->lengths) {
    squares += length.error * length.error;
  }
  const double lengths =
      evaluation->lengths.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(evaluation->lengths.size()));
  const double all = std::hypot(evaluation->overall.rms, lengths);
  return std::isfinite(all) ? all : none;
}

std::string joint_name(int joint) { return fmt::format("q{}", joint + 1); }

}  // namespace artcal
