#include "identification/planning/planning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include <fmt/format.h>

#include "core/random.h"
#include "core/statistics.h"
#include "identification/identifiability/selection.h"
#include "identification/identifiability/svd.h"
#include "identification/least_squares/triangular_factor.h"
#include "identification/planning/ball_patterns.h"
#include "identification/planning/design_pool.h"
#include "identification/planning/exchange.h"

namespace artcal {
namespace {

constexpr int rounds = 4;  // of choosing placements and readings by turns

using Readings = std::vector<int>;  // into PossiblePlacement::readings

/// A placement of the pool, and what is read there.
struct Taken {
  int placement = 0;  ///< into DesignPool::placements
  Readings readings;
};

Readings all_of(const PossiblePlacement& placement) {
  Readings all(placement.readings.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

// `count` readings of each feature, by chance.
Readings some_of(const PossiblePlacement& placement, int count, RandomStream& random) {
  std::map<int, Readings> by_feature;
  for (const int k : all_of(placement)) {
    by_feature[placement.readings[static_cast<std::size_t>(k)].feature].push_back(k);
  }
  Readings some;
  for (auto& [feature, readings] : by_feature) {
    for (int i = 0; i < count && !readings.empty(); ++i) {
      const auto at = static_cast<std::ptrdiff_t>(random.uniform() * static_cast<double>(readings.size()));
      some.push_back(readings[static_cast<std::size_t>(at)]);
      readings.erase(readings.begin() + at);
    }
  }
  std::sort(some.begin(), some.end());
  return some;
}

// Every possible reading at the weight of `count` of each feature: which of them are taken is chosen later.
PossiblePlacement thinned(PossiblePlacement placement, int count) {
  std::map<int, int> counts;
  for (const PossibleReading& reading : placement.readings) {
    ++counts[reading.feature];
  }
  for (PossibleReading& reading : placement.readings) {
    reading.rows *= std::sqrt(std::min(1.0, static_cast<double>(count) / counts[reading.feature]));
  }
  return placement;
}

// What was measured tells of the pool's common columns. An artefact that is in both has the same errors in both; those
// of others are eliminated.
Expected<Eigen::MatrixXd> told_by_measured(const Recording& measured, const Constraints& constraints, const Arm& arm,
                                           const DesignPool& pool, const Noise& noise) {
  const auto own = design_pool(measured, constraints, arm, pool.system.free, noise);
  if (!own) {
    return tl::unexpected(own.error());
  }
  TriangularFactor told(own->common());
  for (const PossiblePlacement& placement : own->placements) {
    told.add(information_of(placement, all_of(placement), own->common()));
  }
  std::vector<int> others;
  std::vector<std::pair<int, int>> same;  // column of its own, column of the pool
  for (int column = 0; column < own->shared; ++column) {
    const auto& names = pool.shared_names;
    const auto found = std::find(names.begin(), names.end(), own->shared_names[static_cast<std::size_t>(column)]);
    if (found == names.end()) {
      others.push_back(column);
      told.add(own->known.row(column));
    } else {
      same.emplace_back(column, static_cast<int>(found - names.begin()));
    }
  }
  const Eigen::MatrixXd triangle = told.triangle();
  const auto leading = static_cast<int>(others.size());
  Eigen::MatrixXd in_pool = Eigen::MatrixXd::Zero(triangle.rows(), leading + pool.common());
  in_pool.leftCols(leading) = triangle(Eigen::all, others);
  for (const auto& [from, to] : same) {
    in_pool.col(leading + to) = triangle.col(from);
  }
  in_pool.rightCols(pool.system.arm_size()) = triangle.rightCols(pool.system.arm_size());
  TriangularFactor factor(leading + pool.common());
  factor.add(in_pool);
  return eliminate_leading(factor.triangle(), leading);
}

/// Choosing and judging over one pool.
class Planner {
 public:
  Planner(const DesignPool& pool, const VirtualArm& arm, const PlanningOptions& options)
      : pool_(pool),
        options_(options),
        chosen_by_(test_lengths(arm, pool, options.noise, options.test_lengths, options.seed)),
        information_of_(test_lengths(arm, pool, options.noise, 10 * options.test_lengths, options.seed + 1)) {}

  // Placements with all their readings at reduced weight, then, by turns, the readings of every placement beside those
  // chosen, and placements with these readings: what came out best.
  [[nodiscard]] std::vector<Taken> choose(const Eigen::MatrixXd& known) const {
    std::vector<Eigen::MatrixXd> told;
    std::vector<Readings> readings;
    RandomStream random(options_.seed, "readings");
    for (const PossiblePlacement& placement : pool_.placements) {
      told.push_back(information_of(thinned(placement, options_.readings), all_of(placement), pool_.common()));
      readings.push_back(some_of(placement, options_.readings, random));
    }
    std::vector<Taken> best;
    double best_u = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round) {
      std::vector<Taken> chosen;
      for (const int p : exchange_placements(known, told, options_.placements, chosen_by_, options_.goal,
                                             options_.starts, options_.seed)) {
        chosen.push_back({p, readings[static_cast<std::size_t>(p)]});
      }
      polish(known, chosen);
      const double u = to_lower(variances_of(with(known, chosen), chosen_by_), options_.goal);
      if (u < best_u) {
        best_u = u;
        best = chosen;
      }
      for (int p = 0; p < static_cast<int>(pool_.placements.size()) && round + 1 < rounds; ++p) {
        const auto at = static_cast<std::size_t>(p);
        exchange_readings(pool_.placements[at], with(known, chosen, p), chosen_by_, options_.goal, readings[at]);
        told[at] = information_of(pool_.placements[at], readings[at], pool_.common());
      }
    }
    return best;
  }

  [[nodiscard]] std::pair<PredictedU, PredictedU> by_chance(const Eigen::MatrixXd& known) const {
    std::vector<double> worst, mean, arm_worst, arm_mean;
    const int wanted = options_.random_placements > 0 ? options_.random_placements : options_.placements;
    for (int i = 0; i < options_.random_plans; ++i) {
      RandomStream random(options_.seed, "random plan", static_cast<std::uint64_t>(i));
      std::vector<Taken> drawn;
      std::vector<int> left(pool_.placements.size());
      std::iota(left.begin(), left.end(), 0);
      for (int n = 0; n < wanted && !left.empty(); ++n) {
        const auto at = static_cast<std::ptrdiff_t>(random.uniform() * static_cast<double>(left.size()));
        const int p = left[static_cast<std::size_t>(at)];
        left.erase(left.begin() + at);
        drawn.push_back({p, some_of(pool_.placements[static_cast<std::size_t>(p)], options_.readings, random)});
      }
      const Eigen::VectorXd variances = variances_of(with(known, drawn), information_of_);
      const PredictedU u = predicted_u(variances);
      const PredictedU of_arm = predicted_u(variances - information_of_.of_noise);
      worst.push_back(u.worst);
      mean.push_back(u.mean);
      arm_worst.push_back(of_arm.worst);
      arm_mean.push_back(of_arm.mean);
    }
    return {{median(worst), median(mean)}, {median(arm_worst), median(arm_mean)}};
  }

  [[nodiscard]] Expectation expect(const Eigen::MatrixXd& triangle, int readings) const {
    const Eigen::VectorXd variances = variances_of(triangle, information_of_);
    return {predicted_u(variances), predicted_u(variances - information_of_.of_noise),
            observability_of(svd(eliminate_leading(triangle, pool_.shared)).values, std::max(1, readings))};
  }

  // What is known with these readings as well; those of placement `but` apart.
  [[nodiscard]] Eigen::MatrixXd with(Eigen::MatrixXd known, const std::vector<Taken>& chosen, int but = -1) const {
    for (const Taken& taken : chosen) {
      if (taken.placement != but) {
        known = together(known, information_of(pool_.placements[static_cast<std::size_t>(taken.placement)],
                                               taken.readings, pool_.common()));
      }
    }
    return known;
  }

 private:
  // The readings of each placement, beside those of the others.
  void polish(const Eigen::MatrixXd& known, std::vector<Taken>& chosen) const {
    for (int round = 0; round < 2; ++round) {
      for (Taken& taken : chosen) {
        exchange_readings(pool_.placements[static_cast<std::size_t>(taken.placement)],
                          with(known, chosen, taken.placement), chosen_by_, options_.goal, taken.readings);
      }
    }
  }

  const DesignPool& pool_;
  const PlanningOptions& options_;
  TestLengths chosen_by_;
  TestLengths information_of_;
};

// The touches of each ball on enough of it.
void spread(const Simulation& possible, const Constraints& constraints, const PossiblePlacement& placement,
            Readings& readings) {
  std::vector<int> chosen;
  for (const int k : readings) {
    chosen.push_back(placement.readings[static_cast<std::size_t>(k)].reading);
  }
  chosen = with_spread_touches(possible, constraints, placement.placement, chosen);
  readings.clear();
  for (const int k : all_of(placement)) {
    if (std::binary_search(chosen.begin(), chosen.end(), placement.readings[static_cast<std::size_t>(k)].reading)) {
      readings.push_back(k);
    }
  }
}

int candidate_of(const Simulation& possible, int placement) {
  const std::string& name = possible.recording.placements.name(placement);
  const auto found = std::find_if(possible.placements.begin(), possible.placements.end(),
                                  [&](const RealPlacement& place) { return place.name == name; });
  return static_cast<int>(found - possible.placements.begin());
}

}  // namespace

Expected<Planning> plan_session(const Simulation& possible, const Constraints& constraints, const Recording* measured,
                                const Constraints* measured_constraints, const PlanningOptions& options) {
  const Arm& arm = possible.arm.arm;
  if (!options.noise.is_given()) {
    return wrong_usage("the noise of the readings is not stated, and what they are worth depends on it");
  }
  const auto selection = select_parameters(arm, {}, {});
  if (!selection) {
    return tl::unexpected(selection.error());
  }
  CouplingOptions asked = coupling_options(*selection);
  asked.noise = options.noise;
  auto coupling = analyse_coupling(possible.recording, constraints, arm, asked);
  if (!coupling) {
    return tl::unexpected(coupling.error());
  }
  if (coupling->scale == ScaleState::Unidentifiable) {
    return no_solution(
        "no calibrated length is in what could be read, so that no choice determines the scale of the arm; plan with a "
        "ball bar, a plate, or anything else with certified distances");
  }
  const auto free = free_parameters(*selection, *coupling);
  if (!free) {
    return tl::unexpected(free.error());
  }
  const auto pool = design_pool(possible.recording, constraints, arm, *free, options.noise);
  if (!pool) {
    return tl::unexpected(pool.error());
  }
  const auto candidates = static_cast<int>(pool->placements.size());
  if (options.placements > candidates) {
    return wrong_usage(
        fmt::format("{} placements are to be chosen, but only {} are possible", options.placements, candidates));
  }
  const Planner planner(*pool, possible.arm, options);
  Eigen::MatrixXd known = pool->known;
  int readings = 0;
  Planning planning;
  if (measured != nullptr) {
    const auto told = told_by_measured(*measured, *measured_constraints, arm, *pool, options.noise);
    if (!told) {
      return tl::unexpected(told.error());
    }
    known = together(known, *told);
    readings = static_cast<int>(measured->readings.size());
    planning.measured = planner.expect(known, readings);
  }
  std::vector<Taken> chosen = planner.choose(known);
  for (Taken& taken : chosen) {
    spread(possible, constraints, pool->placements[static_cast<std::size_t>(taken.placement)], taken.readings);
  }
  int taken = readings;
  for (const auto& [p, indices] : chosen) {
    const PossiblePlacement& placement = pool->placements[static_cast<std::size_t>(p)];
    ChosenPlacement& out = planning.chosen.emplace_back();
    out.candidate = candidate_of(possible, placement.placement);
    for (const int k : indices) {
      out.readings.push_back(placement.readings[static_cast<std::size_t>(k)].reading);
    }
    out.balls = planned_balls(possible, constraints, placement.placement, out.readings);
    taken += static_cast<int>(indices.size());
  }
  std::vector<Taken> everything;
  for (int p = 0; p < candidates; ++p) {
    everything.push_back({p, all_of(pool->placements[static_cast<std::size_t>(p)])});
  }
  planning.planned = planner.expect(planner.with(known, chosen), taken);
  planning.all =
      planner.expect(planner.with(known, everything), readings + static_cast<int>(possible.recording.readings.size()));
  std::tie(planning.random, planning.random_of_arm) = planner.by_chance(known);
  planning.coupling = std::move(*coupling);
  planning.free = *free;
  return planning;
}

}  // namespace artcal
