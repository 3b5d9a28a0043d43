#include "identification/inspection/explanation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "identification/inspection/hypotheses/artefact_hypotheses.h"
#include "identification/inspection/hypotheses/encoder_slip.h"
#include "identification/inspection/hypotheses/hypothesis.h"
#include "identification/inspection/hypotheses/joint_hypotheses.h"
#include "identification/inspection/hypotheses/label_hypotheses.h"
#include "identification/inspection/trial_fit.h"

namespace artcal {
namespace {

constexpr double no_fit = std::numeric_limits<double>::infinity();
constexpr double as_good = 1.5;            // sizes of residuals that do not tell two hypotheses apart
constexpr double better_by_nominal = 0.6;  // of the discrepancy, to be tried with a fit
constexpr double surely_by_nominal = 0.1;
constexpr std::size_t max_fitted = 4;
constexpr std::size_t max_readings = 1500;
constexpr std::size_t max_placements = 8;

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

/// A recording without a mistake that was found, where its residuals are still too large.
struct Unexplained {
  Finding found;
  Bound bound;
  IdentifyOptions options;
  AsWritten as_written;
};

/// The search among all hypotheses about one recording.
class Search {
 public:
  Search(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
         const AsWritten& as_written)
      : recording_(recording),
        constraints_(constraints),
        options_(for_trial(options)),
        as_written_(as_written),
        fits_(recording_, constraints_, options_, as_written_) {}

  void run_radii() {
    if (!free_radius_hypotheses(constraints_).empty()) {  // there are balls of known diameter
      try_all_radii();
    }
  }

  void run() {
    try_gross();
    if (!is_explained()) {
      try_local();
    }
    if (!is_explained()) {
      try_slip();
    }
    if (!is_explained()) {
      try_all(other_table_hypotheses(recording_), recording_.files.size() > 1 ? "a table of another arm or state" : "");
    }
  }

  [[nodiscard]] Explanation explanation() const {
    const Trial* named = best();
    return {named != nullptr ? Findings{finding_of(*named)} : Findings{}, excluded_};
  }

  [[nodiscard]] std::optional<Unexplained> remainder() const {
    const Trial* named = best();
    if (named == nullptr) {
      return std::nullopt;
    }
    AsWritten as_written{named->size, false, named->arm};
    auto bound = applied(named->hypothesis, recording_, constraints_.artefacts);
    if (!bound || !is_unexplained(as_written, recording_, options_)) {
      return std::nullopt;
    }
    IdentifyOptions options = options_;
    options.model.insert(options.model.end(), named->hypothesis.model.begin(), named->hypothesis.model.end());
    return Unexplained{finding_of(*named), std::move(*bound), std::move(options), std::move(as_written)};
  }

  // Where nothing explains the readings: without the gross mistake that the nominal arm shows, if there is one. A
  // second behind it may be all that keeps an arm from fitting.
  [[nodiscard]] std::optional<Unexplained> remainder_by_nominal() const {
    if (!accepted_.empty() || !nearest_) {
      return std::nullopt;
    }
    auto bound = applied(nearest_->hypothesis, recording_, constraints_.artefacts);
    if (!bound) {
      return std::nullopt;
    }
    const Hypothesis& hypothesis = nearest_->hypothesis;
    Finding found{hypothesis.kind, hypothesis.where,
                  fmt::format("{}, the readings deviate by {:.3g} mm from what the nominal arm makes of them, and by "
                              "{:.3g} mm as written. {}",
                              hypothesis.text, nearest_->after, nearest_->before, hypothesis.remedy)};
    AsWritten as_written = fit_as_written(bound->recording, bound->constraints, options_);
    return Unexplained{std::move(found), std::move(*bound), options_, std::move(as_written)};
  }

 private:
  void try_gross() {
    const auto& artefacts = constraints_.artefacts;
    try_ranked(joint_hypotheses(recording_), "joint angles in another unit, order or sign");
    if (!is_explained()) {
      try_ranked(length_hypotheses(recording_, artefacts), "lengths in another unit, positions stated as steps");
    }
    if (!is_explained()) {
      try_ranked(offset_hypotheses(recording_, constraints_), "a joint's zero");
    }
    if (!is_explained()) {
      try_all_radii();
    }
  }

  void try_all_radii() {
    try_all(radius_hypotheses(recording_, constraints_.artefacts), "diameters stated as radii");
    if (!is_explained()) {
      try_radii();
    }
  }

  void try_local() {
    try_all(table_name_hypotheses(recording_), recording_.files.size() > 1 ? "placement names in several tables" : "");
    if (!is_explained()) {
      try_placements();
    }
  }

  [[nodiscard]] bool is_explained() const {
    return std::any_of(accepted_.begin(), accepted_.end(), [&](const Trial& trial) { return fits_.is_enough(trial); });
  }

  void note(const std::string& excluded) {
    if (!excluded.empty()) {
      excluded_.push_back(excluded);
    }
  }

  void accept(Trial&& trial, const std::optional<Arm>& start = {}) {
    if (fits_.explains(trial, start)) {
      accepted_.push_back(std::move(trial));
    }
  }

  void try_all(const std::vector<Hypothesis>& hypotheses, const std::string& excluded) {
    for (const Hypothesis& hypothesis : hypotheses) {
      accept({hypothesis});
    }
    note(excluded);
  }

  // The few that bring the readings nearest to what the nominal arm makes of them.
  void try_ranked(const std::vector<Hypothesis>& hypotheses, const std::string& excluded) {
    const double before = discrepancy({recording_, constraints_}, recording_.arm);
    std::vector<std::pair<double, std::size_t>> ranked;
    for (std::size_t i = 0; i < hypotheses.size(); ++i) {
      const auto bound = applied(hypotheses[i], recording_, constraints_.artefacts);
      const double after = bound ? discrepancy(*bound, bound->recording.arm) : no_fit;
      if (after < better_by_nominal * before) {
        ranked.emplace_back(after, i);
      }
      if (after < surely_by_nominal * before && (!nearest_ || after < nearest_->after)) {
        nearest_ = Nearest{hypotheses[i], before, after};
      }
    }
    std::sort(ranked.begin(), ranked.end());
    for (std::size_t i = 0; i < std::min(ranked.size(), max_fitted); ++i) {
      accept({hypotheses[ranked[i].second]});
    }
    note(excluded);
  }

  void try_radii() {
    for (const Hypothesis& hypothesis : free_radius_hypotheses(constraints_)) {
      Trial trial{hypothesis};
      if (fits_.explains(trial)) {
        describe_radii(trial);
        accepted_.push_back(std::move(trial));
      }
    }
    note("the radii of the tips");
  }

  void describe_radii(Trial& trial) const {
    std::string text;
    bool forgotten = false;
    for (std::size_t p = 0; p < trial.arm.probes.size(); ++p) {
      const Probe& stated = recording_.arm.probes[p];
      forgotten = forgotten || stated.radius == 0.0;
      text += fmt::format("{}with a radius of {:.4g} mm for the tip of probe {}, stated as {:.6g} mm",
                          text.empty() ? "" : ", ", trial.arm.probes[p].radius, in_quotes(stated.name), stated.radius);
    }
    trial.hypothesis.text = text;
    trial.hypothesis.remedy = forgotten ? "State `radius` of the tip's ball in the arm's file; it seems forgotten"
                                        : "Check `radius` of the tip in the arm's file, and the balls' diameters";
  }

  // Placements that do not fit the arm that the others fit, the worst first, and what is wrong in them.
  void try_placements() {
    std::vector<std::pair<double, int>> ranked;
    const Arm& arm = as_written_.arm ? *as_written_.arm : recording_.arm;
    for (int p = 0; p < recording_.placements.size(); ++p) {
      const Recording own = readings_of_placement(recording_, p);
      if (own.readings.empty()) {
        continue;
      }
      const auto bound = build_constraints(own, constraints_.artefacts);
      ranked.emplace_back(bound ? -discrepancy({own, *bound}, arm) : -no_fit, p);
    }
    note(ranked.size() > 1 ? "features exchanged or under another's name, an artefact that moved, in one placement"
                           : "");
    if (ranked.size() < 2) {
      return;
    }
    std::sort(ranked.begin(), ranked.end());
    for (std::size_t i = 0; i < std::min(ranked.size(), max_placements); ++i) {
      Trial without{without_placement(recording_, ranked[i].second)};
      if (fits_.explains(without, as_written_.arm)) {
        try_within(ranked[i].second, without);
        accepted_.push_back(std::move(without));
        return;
      }
    }
  }

  // With the arm that the other placements fit.
  void try_within(int placement, const Trial& without) {
    const Recording own = readings_of_placement(recording_, placement);
    std::vector<std::pair<double, Hypothesis>> ranked;
    for (const Hypothesis& hypothesis : feature_hypotheses(own, constraints_of(own), placement)) {
      const auto bound = applied(hypothesis, own, constraints_.artefacts);
      ranked.emplace_back(bound ? discrepancy(*bound, without.arm) : no_fit, hypothesis);
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& one, const auto& other) { return one.first < other.first; });
    for (std::size_t i = 0; i < std::min(ranked.size(), max_fitted); ++i) {
      accept({std::move(ranked[i].second)}, without.arm);
    }
    for (Hypothesis& hypothesis : move_hypotheses(recording_, constraints_, placement, without.arm)) {
      accept({std::move(hypothesis)}, without.arm);
    }
  }

  [[nodiscard]] Constraints constraints_of(const Recording& part) const {
    return build_constraints(part, constraints_.artefacts).value_or(Constraints{});
  }

  void try_slip() {
    if (const auto slip = find_encoder_slip(recording_, constraints_, options_, as_written_)) {
      accept({slip_hypothesis(recording_, *slip)});
    }
    note("an encoder that slipped or wrapped");
  }

  // Of those that explain the readings equally well, the one that adds least.
  [[nodiscard]] const Trial* best() const {
    double least = no_fit;
    for (const Trial& trial : accepted_) {
      least = std::min(least, trial.size);
    }
    const Trial* named = nullptr;
    for (const Trial& trial : accepted_) {
      if (trial.size <= as_good * least &&
          (named == nullptr ||
           std::pair(trial.hypothesis.complexity, trial.size) < std::pair(named->hypothesis.complexity, named->size))) {
        named = &trial;
      }
    }
    return named;
  }

  [[nodiscard]] Finding finding_of(const Trial& trial) const {
    const Hypothesis& hypothesis = trial.hypothesis;
    const std::string before =
        std::isfinite(as_written_.size) && !as_written_.is_another_arm
            ? fmt::format("deviations fall from {:.3g} mm to {:.2g} mm", as_written_.size, trial.size)
            : fmt::format("an arm {}fits with deviations of {:.2g} mm, and none does as written",
                          as_written_.is_another_arm ? "near the nominal one " : "", trial.size);
    return {hypothesis.kind, hypothesis.where,
            fmt::format("{}{} {}. {}", hypothesis.text, hypothesis.text.ends_with(",") ? "" : ",", before,
                        hypothesis.remedy)};
  }

  const Recording& recording_;
  const Constraints& constraints_;
  IdentifyOptions options_;
  const AsWritten& as_written_;
  TrialFits fits_;
  /// The gross hypothesis that brings the readings nearest to what the nominal arm makes of them.
  struct Nearest {
    Hypothesis hypothesis;
    double before = 0.0, after = 0.0;  ///< discrepancies, mm
  };
  std::optional<Nearest> nearest_;
  std::vector<Trial> accepted_;
  std::vector<std::string> excluded_;
};

using Run = void (Search::*)();

Explanation explained_of(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                         const AsWritten& as_written, Run run) {
  Search first(recording, constraints, options, as_written);
  (first.*run)();
  Explanation explanation = first.explanation();
  const bool is_named = !explanation.findings.empty();
  const auto remainder = is_named ? first.remainder() : first.remainder_by_nominal();
  if (!remainder) {
    return explanation;
  }
  Search second(remainder->bound.recording, remainder->bound.constraints, remainder->options, remainder->as_written);
  (second.*run)();
  if (Explanation further = second.explanation(); !further.findings.empty()) {
    explanation.findings = {remainder->found, std::move(further.findings.front())};
  } else if (is_named) {
    explanation.findings.front().text += fmt::format(
        ". The {:.2g} mm that are left are more than a sound recording leaves: there is a second mistake, or "
        "the arm has errors that the model lacks",
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
  return explained(recording, constraints, options, as_written, &Search::run);
}

Explanation explain_by_radii(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                             const AsWritten& as_written) {
  return explained(recording, constraints, options, as_written, &Search::run_radii);
}

}  // namespace artcal
