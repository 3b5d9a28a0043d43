#include "identification/inspection/mistake_search.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "identification/inspection/hypotheses/artefact_hypotheses.h"
#include "identification/inspection/hypotheses/encoder_slip.h"
#include "identification/inspection/hypotheses/joint_hypotheses.h"
#include "identification/inspection/hypotheses/label_hypotheses.h"
#include "identification/inspection/named_trial.h"

namespace artcal {
namespace {

constexpr double no_fit = std::numeric_limits<double>::infinity();
constexpr double better_by_nominal = 0.6;  // of the discrepancy, to be tried with a fit
constexpr double surely_by_nominal = 0.1;
constexpr std::size_t max_fitted = 4;
constexpr std::size_t max_placements = 8;

}  // namespace

MistakeSearch::MistakeSearch(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                             const AsWritten& as_written)
    : recording_(recording),
      constraints_(constraints),
      options_(for_trial(options)),
      as_written_(as_written),
      fits_(recording_, constraints_, options_, as_written_) {}

void MistakeSearch::run_radii() {
  if (!free_radius_hypotheses(constraints_).empty()) {  // there are balls of known diameter
    try_all_radii();
  }
}

void MistakeSearch::run() {
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

Explanation MistakeSearch::explanation() const {
  const Trial* named = simplest_of(accepted_);
  return {named != nullptr ? Findings{finding_of(*named, as_written_)} : Findings{}, excluded_};
}

std::optional<Unexplained> MistakeSearch::remainder() const {
  const Trial* named = simplest_of(accepted_);
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
  return Unexplained{finding_of(*named, as_written_), std::move(*bound), std::move(options), std::move(as_written)};
}

std::optional<Unexplained> MistakeSearch::remainder_by_nominal() const {
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

void MistakeSearch::try_gross() {
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

void MistakeSearch::try_all_radii() {
  try_all(radius_hypotheses(recording_, constraints_.artefacts), "diameters stated as radii");
  if (!is_explained()) {
    try_radii();
  }
}

void MistakeSearch::try_local() {
  try_all(table_name_hypotheses(recording_), recording_.files.size() > 1 ? "placement names in several tables" : "");
  if (!is_explained()) {
    try_placements();
  }
}

bool MistakeSearch::is_explained() const {
  return std::any_of(accepted_.begin(), accepted_.end(), [&](const Trial& trial) { return fits_.is_enough(trial); });
}

void MistakeSearch::note(const std::string& excluded) {
  if (!excluded.empty()) {
    excluded_.push_back(excluded);
  }
}

void MistakeSearch::accept(Trial&& trial, const std::optional<Arm>& start) {
  if (fits_.explains(trial, start)) {
    accepted_.push_back(std::move(trial));
  }
}

void MistakeSearch::try_all(const std::vector<Hypothesis>& hypotheses, const std::string& excluded) {
  for (const Hypothesis& hypothesis : hypotheses) {
    accept({hypothesis});
  }
  note(excluded);
}

// The few that bring the readings nearest to what the nominal arm makes of them.
void MistakeSearch::try_ranked(const std::vector<Hypothesis>& hypotheses, const std::string& excluded) {
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
    Trial trial{hypotheses[ranked[i].second]};
    trial.is_sure_by_nominal = ranked[i].first < surely_by_nominal * before;
    accept(std::move(trial));
  }
  note(excluded);
}

void MistakeSearch::try_radii() {
  for (const Hypothesis& hypothesis : free_radius_hypotheses(constraints_)) {
    Trial trial{hypothesis};
    if (fits_.explains(trial)) {
      describe_radii(trial, recording_.arm);
      accepted_.push_back(std::move(trial));
    }
  }
  note("the radii of the tips");
}

// Placements that do not fit the arm that the others fit, the worst first, and what is wrong in them.
void MistakeSearch::try_placements() {
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
  note(ranked.size() > 1 ? "features exchanged or under another's name, an artefact that moved, in one placement" : "");
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
void MistakeSearch::try_within(int placement, const Trial& without) {
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

Constraints MistakeSearch::constraints_of(const Recording& part) const {
  return build_constraints(part, constraints_.artefacts).value_or(Constraints{});
}

void MistakeSearch::try_slip() {
  if (const auto slip = find_encoder_slip(recording_, constraints_, options_, as_written_)) {
    accept({slip_hypothesis(recording_, *slip)});
  }
  note("an encoder that slipped or wrapped");
}

}  // namespace artcal
