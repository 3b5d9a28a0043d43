#include "identification/models/automatic_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <boost/math/distributions/students_t.hpp>

#include "acquisition/arm/parallel_axes.h"
#include "acquisition/recording/tip_centres.h"
#include "identification/evaluation/judgement.h"
#include "identification/models/tried_model.h"

namespace artcal {
namespace {

// Chance that a step takes any group where none improves anything.
constexpr double false_alarms_of_a_step = 0.05;
constexpr std::size_t min_placements = 3;

// How many standard errors an improvement must be, one-sided, among `groups` tried (Bonferroni).
double limit_of(std::size_t placements, std::size_t groups) {
  const boost::math::students_t distribution(static_cast<double>(placements) - 1.0);
  return boost::math::quantile(
      boost::math::complement(distribution, false_alarms_of_a_step / static_cast<double>(groups)));
}

/// How an arm does on a placement that its identification has not seen.
struct Unseen {
  double count = 0.0;
  double squares = 0.0;

  [[nodiscard]] double mean_square() const { return squares / count; }
};

std::vector<Unseen> unseen_of(const std::vector<LeftOut>& left_out) {
  std::vector<Unseen> all;
  for (const LeftOut& left : left_out) {
    Unseen& unseen = all.emplace_back();
    unseen.count = left.deviation.readings + static_cast<double>(left.lengths.size());
    unseen.squares = left.deviation.readings * left.deviation.rms * left.deviation.rms;
    for (const LengthDeviation& length : left.lengths) {
      unseen.squares += length.error * length.error;
    }
  }
  return all;
}

const LeftOut* first_refused(const std::vector<LeftOut>& left_out) {
  const auto found =
      std::find_if(left_out.begin(), left_out.end(), [](const LeftOut& left) { return !left.refusal.empty(); });
  return found == left_out.end() ? nullptr : &*found;
}

std::string first_refusal(const std::vector<LeftOut>& left_out) {
  const LeftOut* left = first_refused(left_out);
  return left == nullptr ? ""
                         : fmt::format("without the placement {}: {}", left->deviation.name.placement, left->refusal);
}

double rms_of(const std::vector<Unseen>& all) {
  Unseen sum;
  for (const Unseen& unseen : all) {
    sum.count += unseen.count;
    sum.squares += unseen.squares;
  }
  return std::sqrt(sum.mean_square());
}

// Fills improvement and noise of a trial, as shares of the mean square before.
void compare(const std::vector<Unseen>& before, const std::vector<Unseen>& after, ModelTrial& trial) {
  const double total = std::accumulate(before.begin(), before.end(), 0.0,
                                       [](double sum, const Unseen& unseen) { return sum + unseen.count; });
  const auto share = [&](std::size_t p) { return before[p].count / total; };
  const auto fall = [&](std::size_t p) { return before[p].mean_square() - after[p].mean_square(); };
  double mean = 0.0;
  double square = 0.0;
  for (std::size_t p = 0; p < before.size(); ++p) {
    mean += share(p) * fall(p);
  }
  for (std::size_t p = 0; p < before.size(); ++p) {
    square += std::pow(share(p) * (fall(p) - mean), 2);
  }
  const auto count = static_cast<double>(before.size());
  const double whole = std::pow(rms_of(before), 2);
  trial.improvement = mean / whole;
  trial.improvement_noise = std::sqrt(count / (count - 1.0) * square) / whole;
}

ModelTrial described(const TriedModel& tried, const Model& model, int step) {
  ModelTrial trial;
  trial.step = step;
  trial.model = model;
  trial.parameters = static_cast<int>(tried.estimate.preparation.free.size());
  trial.left_out_rms = rms_of(unseen_of(tried.left_out));
  return trial;
}

ModelTrial refused(int step, const Model& model, std::string why) {
  ModelTrial trial;
  trial.step = step;
  trial.model = model;
  trial.verdict = ModelTrial::Verdict::Refused;
  trial.refusal = std::move(why);
  return trial;
}

std::vector<ParameterGroup> groups_beside(const Model& model) {
  std::vector<ParameterGroup> groups;
  for (int i = 0; i < parameter_groups; ++i) {
    const auto group = static_cast<ParameterGroup>(i);
    if (std::find(model.begin(), model.end(), group) == model.end()) {
      groups.push_back(group);
    }
  }
  return groups;
}

// Progress within one model among many names the model.
IdentifyProgressCallback named(const IdentifyProgressCallback& progress, const Model& model) {
  if (!progress) {
    return {};
  }
  return [&progress, name = model_text(model)](const std::string& what, std::size_t done, std::size_t total) {
    progress(fmt::format("model {}, {}", name, what), done, total);
  };
}

// What a narrow model leaves of the residuals, a wider one may explain: misfits are judged at the end.
IdentifyOptions options_for(const Model& model, const IdentifyOptions& options) {
  IdentifyOptions own = options;
  own.model = model;
  own.automatic = false;
  own.accept_misfit = true;
  own.progress = named(options.progress, model);
  return own;
}

/// The search on its way: the best model so far and the groups that may still join it.
class ModelSearch {
 public:
  ModelSearch(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options)
      : recording_(recording), constraints_(constraints), options_(options), model_(options.model) {}

  Expected<void> begin() {
    auto tried = try_model(recording_, constraints_, options_for(model_, options_));
    if (!tried) {
      return tl::unexpected(tried.error());
    }
    if (tried->left_out.size() < min_placements) {
      return wrong_usage(
          fmt::format("--model auto judges groups by placements that are left out, and needs at least {}; "
                      "this recording has {}",
                      min_placements, tried->estimate.after.placements.size()));
    }
    if (const LeftOut* left = first_refused(tried->left_out)) {
      return no_solution("--model auto cannot judge the model to begin with: " + first_refusal(tried->left_out),
                         left->refusal_kind);
    }
    best_ = std::move(*tried);
    trials_.push_back(described(*best_, model_, 0));
    candidates_ = groups_beside(model_);
    if (!parallel_axes(recording_.arm).empty()) {
      std::erase(candidates_, ParameterGroup::Hayati);  // every model has it where it makes sense
    }
    return {};
  }

  // Tries each group beside the best model and takes the best of those that are worth it; false where none is.
  bool step() {
    const int number = ++steps_;
    std::vector<std::pair<std::size_t, TriedModel>> judged;  // with the places of their trials
    for (auto group = candidates_.begin(); group != candidates_.end();) {
      Model wider = model_;
      wider.push_back(*group);
      auto tried = tried_with(wider);
      const std::string why = tried ? first_refusal(tried->left_out) : tried.error().text();
      if (!why.empty()) {
        // What cannot be determined now cannot be determined beside more parameters either.
        trials_.push_back(refused(number, wider, why));
        group = candidates_.erase(group);
        continue;
      }
      trials_.push_back(described(*tried, wider, number));
      compare(unseen_of(best_->left_out), unseen_of(tried->left_out), trials_.back());
      judged.emplace_back(trials_.size() - 1, std::move(*tried));
      ++group;
    }
    std::pair<std::size_t, TriedModel>* taken = nullptr;
    for (auto& candidate : judged) {
      ModelTrial& trial = trials_[candidate.first];
      trial.limit = limit_of(best_->left_out.size(), judged.size());
      const bool worth = trial.improvement > trial.limit * trial.improvement_noise;
      trial.verdict = worth ? ModelTrial::Verdict::Worth : ModelTrial::Verdict::NotWorth;
      if (worth && (taken == nullptr || trial.left_out_rms < trials_[taken->first].left_out_rms)) {
        taken = &candidate;
      }
    }
    if (taken == nullptr) {
      return false;
    }
    trials_[taken->first].verdict = ModelTrial::Verdict::Taken;
    model_ = trials_[taken->first].model;
    best_ = std::move(taken->second);
    std::erase(candidates_, model_.back());
    return !candidates_.empty();
  }

  // The whole identification with the model found.
  Expected<Identification> result() && {
    IdentifyOptions own = options_for(model_, options_);
    own.accept_misfit = options_.accept_misfit;
    // As if the model had been asked for, to the last digit; from the arm that was tried only if that fails.
    auto found = identify(recording_, constraints_, own);
    if (!found && found.error().code == ErrorCode::NoSolution) {
      own.start = start_for();
      found = identify(recording_, constraints_, own);
    }
    if (found) {
      found->left_out_chose_the_model = model_.size() > options_.model.size();
      found->trials = std::move(trials_);
    }
    return found;
  }

 private:
  // From the best arm so far, which a wider model contains.
  [[nodiscard]] std::optional<Arm> start_for() const {
    return best_ && best_->estimate.misfits.empty() && best_->estimate.fixed.empty()
               ? std::optional(best_->estimate.fit.arm)
               : options_.start;
  }

  // From the best arm so far where that leads to the same answer as the nominal one: which members of a group are
  // fixed, and what can be left out, may depend on the way.
  [[nodiscard]] Expected<TriedModel> tried_with(const Model& model) const {
    IdentifyOptions own = options_for(model, options_);
    own.start = start_for();
    auto tried = try_model(recording_, constraints_, own);
    const bool is_determined = tried && tried->estimate.fixed.empty() && first_refusal(tried->left_out).empty();
    if (!own.start || !tried || is_determined) {
      return tried;
    }
    own.start = options_.start;
    return try_model(recording_, constraints_, own);
  }

  const Recording& recording_;
  const Constraints& constraints_;
  const IdentifyOptions& options_;
  Model model_;
  std::optional<TriedModel> best_;
  std::vector<ParameterGroup> candidates_;
  std::vector<ModelTrial> trials_;
  int steps_ = 0;
};

}  // namespace

Expected<Identification> identify_automatically(const Recording& recording, const Constraints& constraints,
                                                const IdentifyOptions& options) {
  if (!options.leave_out) {
    return wrong_usage("--model auto judges groups by placements that are left out, and these are not to be");
  }
  if (auto there = require_joints(recording); !there) {
    return tl::unexpected(there.error());
  }
  ModelSearch search(recording, constraints, options);
  if (auto begun = search.begin(); !begun) {
    return tl::unexpected(begun.error());
  }
  while (search.step()) {
  }
  return std::move(search).result();
}

}  // namespace artcal
