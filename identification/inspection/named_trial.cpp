#include "identification/inspection/named_trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr double as_good = 1.5;  // sizes of residuals that do not tell two hypotheses apart

}  // namespace

const Trial* simplest_of(const std::vector<Trial>& accepted) {
  double least = std::numeric_limits<double>::infinity();
  for (const Trial& trial : accepted) {
    least = std::min(least, trial.size);
  }
  const Trial* named = nullptr;
  for (const Trial& trial : accepted) {
    if (trial.size <= as_good * least &&
        (named == nullptr ||
         std::pair(trial.hypothesis.complexity, trial.size) < std::pair(named->hypothesis.complexity, named->size))) {
      named = &trial;
    }
  }
  return named;
}

Finding finding_of(const Trial& trial, const AsWritten& as_written) {
  const Hypothesis& hypothesis = trial.hypothesis;
  const std::string before =
      std::isfinite(as_written.size) && !as_written.is_another_arm
          ? fmt::format("deviations fall from {:.3g} mm to {:.2g} mm", as_written.size, trial.size)
          : fmt::format("an arm {}fits with deviations of {:.2g} mm, and none does as written",
                        as_written.is_another_arm ? "near the nominal one " : "", trial.size);
  return {hypothesis.kind, hypothesis.where,
          fmt::format("{}{} {}. {}", hypothesis.text, hypothesis.text.ends_with(",") ? "" : ",", before,
                      hypothesis.remedy)};
}

void describe_radii(Trial& trial, const Arm& stated) {
  std::string text;
  bool forgotten = false;
  for (std::size_t p = 0; p < trial.arm.probes.size(); ++p) {
    const Probe& probe = stated.probes[p];
    forgotten = forgotten || probe.radius == 0.0;
    text += fmt::format("{}with a radius of {:.4g} mm for the tip of probe {}, stated as {:.6g} mm",
                        text.empty() ? "" : ", ", trial.arm.probes[p].radius, in_quotes(probe.name), probe.radius);
  }
  trial.hypothesis.text = text;
  trial.hypothesis.remedy = forgotten ? "State `radius` of the tip's ball in the arm's file; it seems forgotten"
                                      : "Check `radius` of the tip in the arm's file, and the balls' diameters";
}

}  // namespace artcal
