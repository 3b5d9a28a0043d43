#include "identification/planning/exchange.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include <Eigen/Cholesky>

#include "core/random.h"
#include "identification/least_squares/triangular_factor.h"

namespace artcal {
namespace {

constexpr int deepest = 3;          // placements that one excursion adds before it takes as many away
constexpr double better_by = 1e-6;  // relative; less is rounding

/// A choice of placements and what it comes to.
struct Choice {
  std::vector<int> placements;
  Eigen::MatrixXd triangle;
  double u = std::numeric_limits<double>::infinity();
};

void keep_better(Choice& best, Choice other) {
  if (other.u < best.u) {
    best = std::move(other);
  }
}

class PlacementExchange {
 public:
  PlacementExchange(const Eigen::MatrixXd& known, const std::vector<Eigen::MatrixXd>& told, const TestLengths& lengths,
                    Goal goal)
      : known_(known), told_(told), lengths_(lengths), goal_(goal) {}

  [[nodiscard]] Choice of(std::vector<int> placements) const {
    Choice choice{std::move(placements), known_};
    for (const int placement : choice.placements) {
      choice.triangle = together(choice.triangle, told_[static_cast<std::size_t>(placement)]);
    }
    choice.u = u_of(choice.triangle);
    return choice;
  }

  [[nodiscard]] Choice with_best(const Choice& choice) const {
    Choice best;
    for (int placement = 0; placement < static_cast<int>(told_.size()); ++placement) {
      if (std::find(choice.placements.begin(), choice.placements.end(), placement) == choice.placements.end()) {
        Choice next{choice.placements, together(choice.triangle, told_[static_cast<std::size_t>(placement)])};
        next.placements.push_back(placement);
        next.u = u_of(next.triangle);
        keep_better(best, std::move(next));
      }
    }
    return best;
  }

  [[nodiscard]] Choice without_least(const Choice& choice) const {
    Choice best;
    for (std::size_t i = 0; i < choice.placements.size(); ++i) {
      std::vector<int> rest = choice.placements;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      Choice next = of(std::move(rest));
      keep_better(best, std::move(next));
    }
    return best;
  }

  [[nodiscard]] Choice improved(Choice choice) const {
    for (int depth = 1; depth <= deepest;) {
      const int room = static_cast<int>(told_.size() - choice.placements.size());
      Choice next = choice;
      const int steps = std::min(depth, room);
      for (int i = 0; i < steps; ++i) next = with_best(next);
      for (int i = 0; i < steps; ++i) next = without_least(next);
      const bool better = next.u < (1.0 - better_by) * choice.u;
      depth = better ? 1 : depth + 1;
      if (better) {
        choice = std::move(next);
      }
    }
    return choice;
  }

 private:
  [[nodiscard]] double u_of(const Eigen::MatrixXd& triangle) const {
    return to_lower(variances_of(triangle, lengths_), goal_);
  }

  const Eigen::MatrixXd& known_;
  const std::vector<Eigen::MatrixXd>& told_;
  const TestLengths& lengths_;
  Goal goal_;
};

std::vector<int> random_choice(int of, int count, RandomStream& random) {
  std::vector<int> all(static_cast<std::size_t>(of));
  std::iota(all.begin(), all.end(), 0);
  for (int i = 0; i < count; ++i) {
    const auto j = static_cast<std::size_t>(i + random.uniform() * (of - i));
    std::swap(all[static_cast<std::size_t>(i)], all[j]);
  }
  all.resize(static_cast<std::size_t>(count));
  return all;
}

/// One placement's readings as changes of the lengths' variances.
class ReadingExchange {
 public:
  ReadingExchange(const PossiblePlacement& placement, const Eigen::MatrixXd& known, const TestLengths& lengths,
                  Goal goal)
      : placement_(placement), known_(known), lengths_(lengths), goal_(goal) {}

  // One reading in and the one of the same feature that is missed least out. False where that is the same one.
  bool step(std::vector<int>& chosen) {
    update(chosen);
    const double before = to_lower(variances_, goal_);
    const int in = best_of(complement(chosen), 1.0);
    if (in < 0) {
      return false;
    }
    std::vector<int> more = chosen;
    more.push_back(in);
    update(more);
    std::vector<int> alike;
    for (const int k : more) {
      if (reading(k).feature == reading(in).feature) alike.push_back(k);
    }
    const int out = best_of(alike, -1.0);
    if (out < 0 || out == in) {
      return false;
    }
    std::erase(more, out);
    update(more);
    if (!(to_lower(variances_, goal_) < (1.0 - better_by) * before)) {
      return false;
    }
    chosen = std::move(more);
    return true;
  }

 private:
  [[nodiscard]] const PossibleReading& reading(int k) const { return placement_.readings[static_cast<std::size_t>(k)]; }

  [[nodiscard]] std::vector<int> complement(const std::vector<int>& chosen) const {
    std::vector<int> rest;
    for (int k = 0; k < static_cast<int>(placement_.readings.size()); ++k) {
      if (std::find(chosen.begin(), chosen.end(), k) == chosen.end()) rest.push_back(k);
    }
    return rest;
  }

  void update(const std::vector<int>& chosen) {
    const auto columns = placement_.unknowns + known_.cols();
    TriangularFactor factor(static_cast<int>(columns));
    Eigen::MatrixXd anyway = Eigen::MatrixXd::Zero(known_.rows(), columns);
    anyway.rightCols(known_.cols()) = known_;
    factor.add(anyway);
    if (placement_.certified.rows() > 0) factor.add(placement_.certified);
    for (const int k : chosen) factor.add(reading(k).rows);
    triangle_ = factor.triangle();
    Eigen::MatrixXd gradients = Eigen::MatrixXd::Zero(columns, lengths_.by_common.cols());
    gradients.bottomRows(known_.cols()) = lengths_.by_common;
    lengths_seen_ = solved(gradients);
    variances_ = lengths_seen_.colwise().squaredNorm().transpose() + lengths_.of_noise;
  }

  [[nodiscard]] Eigen::MatrixXd solved(const Eigen::MatrixXd& rows) const {
    return triangle_.transpose().triangularView<Eigen::Lower>().solve(rows);
  }

  // (RᵀR ± AᵀA)⁻¹ by Woodbury: a reading with rows A, W = R⁻ᵀAᵀ, changes yᵀ(RᵀR)⁻¹y by ∓ |L⁻¹Wᵀ R⁻ᵀy|², LLᵀ = I ± WᵀW.
  [[nodiscard]] int best_of(const std::vector<int>& candidates, double sign) const {
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (const int k : candidates) {
      const Eigen::MatrixXd w = solved(reading(k).rows.transpose());
      const Eigen::MatrixXd inner = Eigen::MatrixXd::Identity(w.cols(), w.cols()) + sign * w.transpose() * w;
      const Eigen::LLT<Eigen::MatrixXd> cholesky(inner);
      if (cholesky.info() != Eigen::Success || !(Eigen::MatrixXd(cholesky.matrixL()).diagonal().minCoeff() > 1e-6)) {
        continue;  // without it the rest would not be told
      }
      const Eigen::MatrixXd change = cholesky.matrixL().solve(w.transpose() * lengths_seen_);
      const double u = to_lower(variances_ - sign * change.colwise().squaredNorm().transpose(), goal_);
      if (u < least) {
        least = u;
        best = k;
      }
    }
    return best;
  }

  const PossiblePlacement& placement_;
  const Eigen::MatrixXd& known_;
  const TestLengths& lengths_;
  Goal goal_;
  Eigen::MatrixXd triangle_;
  Eigen::MatrixXd lengths_seen_;
  Eigen::VectorXd variances_;
};

}  // namespace

std::vector<int> exchange_placements(const Eigen::MatrixXd& known, const std::vector<Eigen::MatrixXd>& told, int count,
                                     const TestLengths& lengths, Goal goal, int starts, std::uint64_t seed) {
  const PlacementExchange exchange(known, told, lengths, goal);
  Choice best;
  for (int start = 0; start < starts; ++start) {
    RandomStream random(seed, "start", static_cast<std::uint64_t>(start));
    Choice choice = exchange.improved(exchange.of(random_choice(static_cast<int>(told.size()), count, random)));
    if (start == 0 || choice.u < (1.0 - better_by) * best.u) {
      best = std::move(choice);
    }
  }
  std::sort(best.placements.begin(), best.placements.end());
  return best.placements;
}

void exchange_readings(const PossiblePlacement& placement, const Eigen::MatrixXd& known, const TestLengths& lengths,
                       Goal goal, std::vector<int>& chosen) {
  ReadingExchange exchange(placement, known, lengths, goal);
  for (std::size_t i = 0; i < 2 * chosen.size() && exchange.step(chosen); ++i) {
  }
  std::sort(chosen.begin(), chosen.end());
}

}  // namespace artcal
