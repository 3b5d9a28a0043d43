#include "identification/models/automatic_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <boost/math/distributions/students_t.hpp>

#include "identification/evaluation/judgement.h"

namespace artcal {
namespace {

// Chance that a step takes any group where none improves anything.
constexpr double false_alarms = 0.05;
constexpr std::size_t min_placements = 3;

// How many standard errors an improvement must be, one-sided, among `groups` tried (Bonferroni).
double limit_of(std::size_t placements, std::size_t groups) {
  const boost::math::students_t distribution(static_cast<double>(placements) - 1.0);
  return boost::math::quantile(boost::math::complement(distribution, false_alarms / static_cast<double>(groups)));
}

/// How an arm does on a placement that its identification has not seen.
struct Unseen {
  double count = 0.0;
  double squares = 0.0;

  [[nodiscard]] double mean_square() const { return squares / count; }
};

std::vector<Unseen> unseen_of(const Identification& result) {
  std::vector<Unseen> all;
  for (const LeftOut& left : result.left_out) {
    Unseen& unseen = all.emplace_back();
    unseen.count = left.deviation.readings + static_cast<double>(left.lengths.size());
    unseen.squares = left.deviation.readings * left.deviation.rms * left.deviation.rms;
    for (const LengthDeviation& length : left.lengths) {
      unseen.squares += length.error * length.error;
    }
  }
  return all;
}

std::string first_refusal(const Identification& result) {
  for (const LeftOut& left : result.left_out) {
    if (!left.refusal.empty()) {
      return fmt::format("without the placement {}: {}", left.deviation.name.placement, left.refusal);
    }
  }
  return "";
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

ModelTrial described(const Identification& result, int step) {
  ModelTrial trial;
  trial.step = step;
  trial.model = result.model;
  trial.parameters = static_cast<int>(result.free.size());
  trial.left_out_rms = rms_of(unseen_of(result));
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

// What is told of one identification among many says which.
IdentifyProgressCallback named(const IdentifyProgressCallback& progress, const Model& model) {
  if (!progress) {
    return {};
  }
  return [&progress, name = model_text(model)](const std::string& what, std::size_t done, std::size_t total) {
    progress(fmt::format("model {}, {}", name, what), done, total);
  };
}

}  // namespace

Expected<Identification> identify_automatically(const Recording& recording, const Constraints& constraints,
                                                const IdentifyOptions& options) {
  if (!options.leave_out) {
    return wrong_usage("--model auto judges groups by placements that are left out, and these are not to be");
  }
  // What a narrow model leaves of the residuals, a wider one may explain: judged is the last.
  IdentifyOptions judged_later = options;
  judged_later.accept_misfit = true;
  auto best = identify(recording, constraints, judged_later);
  if (!best) {
    return best;
  }
  if (best->left_out.size() < min_placements) {
    return wrong_usage(
        fmt::format("--model auto judges groups by placements that are left out, and needs at least {}; "
                    "this recording has {}",
                    min_placements, best->after.placements.size()));
  }
  if (const std::string why = first_refusal(*best); !why.empty()) {
    return no_solution("--model auto cannot judge the model to begin with: " + why);
  }
  std::vector<ModelTrial> trials{described(*best, 0)};
  std::vector<ParameterGroup> candidates = groups_beside(options.model);
  for (int step = 1; !candidates.empty(); ++step) {
    const auto before = unseen_of(*best);
    std::vector<Identification> results;
    std::vector<std::size_t> judged;  // their trials
    for (auto group = candidates.begin(); group != candidates.end();) {
      IdentifyOptions wider = judged_later;
      wider.model = best->model;
      wider.model.push_back(*group);
      wider.progress = named(options.progress, wider.model);
      auto result = identify(recording, constraints, wider);
      const std::string why = result ? first_refusal(*result) : result.error().text();
      if (!why.empty()) {
        // What cannot be determined now cannot be determined beside more parameters either.
        trials.push_back(refused(step, wider.model, why));
        group = candidates.erase(group);
        continue;
      }
      judged.push_back(trials.size());
      trials.push_back(described(*result, step));
      compare(before, unseen_of(*result), trials.back());
      results.push_back(std::move(*result));
      ++group;
    }
    std::optional<Identification> better;
    std::size_t taken = 0;
    for (std::size_t i = 0; i < judged.size(); ++i) {
      ModelTrial& trial = trials[judged[i]];
      trial.limit = limit_of(before.size(), judged.size());
      const bool worth = trial.improvement > trial.limit * trial.improvement_noise;
      trial.verdict = worth ? ModelTrial::Verdict::Worth : ModelTrial::Verdict::NotWorth;
      if (worth && (!better || trial.left_out_rms < trials[taken].left_out_rms)) {
        better = std::move(results[i]);
        taken = judged[i];
      }
    }
    if (!better) {
      break;
    }
    trials[taken].verdict = ModelTrial::Verdict::Taken;
    best = std::move(*better);
    std::erase(candidates, best->model.back());
  }
  if (!best->misfits.empty() && !options.accept_misfit) {
    return tl::unexpected(misfit_error(best->misfits, best->attempts));
  }
  best->left_out_chose_the_model = best->model.size() > options.model.size();
  best->trials = std::move(trials);
  return best;
}

}  // namespace artcal
