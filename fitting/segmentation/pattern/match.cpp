#include "fitting/segmentation/pattern/match.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace artcal {
namespace {

constexpr std::size_t max_ways = 1000;
constexpr long max_steps = 3'000'000;

Expected<void> check(const Pattern& pattern, const std::vector<PlaceHint>& hints) {
  const auto count = static_cast<Eigen::Index>(pattern.radii.size());
  if (pattern.distances.rows() != count || pattern.distances.cols() != count) {
    return wrong_usage(fmt::format("{} points and {} x {} distances do not belong together", count,
                                   pattern.distances.rows(), pattern.distances.cols()));
  }
  if (!(pattern.tolerance > 0.0)) {
    return wrong_usage("the tolerance of the distances is not above zero");
  }
  for (const PlaceHint& hint : hints) {
    if (hint.point < 0 || hint.point >= count) {
      return wrong_usage(fmt::format("point {} is named, but there are {}", hint.point, count));
    }
  }
  return {};
}

// Points in an order in which each has as many certified distances to those before it as can be.
std::vector<int> order_of(const Eigen::MatrixXd& distances) {
  std::vector<int> order;
  std::vector<char> taken(static_cast<std::size_t>(distances.rows()), 0);
  while (order.size() < taken.size()) {
    int best = -1;
    int most = -1;
    for (int i = 0; i < static_cast<int>(taken.size()); ++i) {
      const auto known = [&](int j) { return i != j && std::isfinite(distances(i, j)); };
      const int links = static_cast<int>(std::count_if(order.begin(), order.end(), known));
      if (taken[i] == 0 && links > most) {
        best = i;
        most = links;
      }
    }
    taken[best] = 1;
    order.push_back(best);
  }
  return order;
}

// Fewer than half may be chance, and one distance is the least that says anything.
int fewest(int points) { return std::max(std::min(2, points), (points + 1) / 2); }

/// Depth-first over the pattern's points: each takes every found point that its distances allow, or none.
class DepthFirstSearch {
 public:
  DepthFirstSearch(const Pattern& pattern, const std::vector<FoundPoint>& found, std::vector<int> wanted)
      : pattern_(pattern),
        found_(found),
        order_(order_of(pattern.distances)),
        now_(pattern.radii.size(), -1),
        used_(found.size(), 0),
        wanted_(std::move(wanted)) {
    best_ = fewest(static_cast<int>(pattern.radii.size()));
  }

  Expected<Matching> run() {
    step(0, 0);
    if (steps_ >= max_steps) {
      return no_solution(
          "the certified distances leave too many ways to name the spheres; state more distances or coordinates, or "
          "leave fewer surroundings in the scan");
    }
    for (auto& way : matching_.ways) {
      judge(way);
    }
    std::stable_sort(matching_.ways.begin(), matching_.ways.end(),
                     [](const Assignment& a, const Assignment& b) { return a.rms < b.rms; });
    return std::move(matching_);
  }

 private:
  [[nodiscard]] double deviation(int a, int b) const {
    return (found_[now_[a]].at - found_[now_[b]].at).norm() - pattern_.distances(a, b);
  }

  [[nodiscard]] bool is_linked(int point, int other) const {
    return now_[other] >= 0 && std::isfinite(pattern_.distances(point, other));
  }

  [[nodiscard]] bool fits(std::size_t depth) const {
    const int point = order_[depth];
    return std::all_of(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(depth), [&](int other) {
      return !is_linked(point, other) || std::abs(deviation(point, other)) <= pattern_.tolerance;
    });
  }

  void step(std::size_t depth, int count) {
    const auto left = std::min(order_.size() - depth, found_.size() - static_cast<std::size_t>(count));
    if (++steps_ >= max_steps || count + static_cast<int>(left) < best_) {
      return;
    }
    if (depth == order_.size()) {
      keep(count);
      return;
    }
    const int point = order_[depth];
    bool taken = false;
    for (int i = 0; i < static_cast<int>(found_.size()); ++i) {
      const bool may = used_[i] == 0 && (wanted_[point] < 0 || wanted_[point] == i) &&
                       std::abs(found_[i].radius - pattern_.radii[point]) < 1e-9 * pattern_.radii[point];
      if (!may) {
        continue;
      }
      now_[point] = i;
      used_[i] = 1;
      if (fits(depth)) {
        taken = true;
        step(depth + 1, count + 1);
      }
      used_[i] = 0;
      now_[point] = -1;
    }
    // What stands where four others want it need not be tried as missing: nothing else could stand there.
    const auto links = std::count_if(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(depth),
                                     [&](int other) { return is_linked(point, other); });
    if (wanted_[point] < 0 && !(taken && links >= 4)) {
      step(depth + 1, count);
    }
  }

  void keep(int count) {
    if (count > best_) {
      matching_ = {};
      best_ = count;
    }
    if (matching_.ways.size() < max_ways) {
      matching_.ways.push_back({now_, count, 0.0, 0.0});
    } else {
      matching_.there_are_more = true;
    }
  }

  void judge(Assignment& way) {
    now_ = way.found;
    double squares = 0.0;
    int distances = 0;
    for (int a = 0; a < static_cast<int>(now_.size()); ++a) {
      for (int b = 0; b < a; ++b) {
        if (now_[a] >= 0 && now_[b] >= 0 && std::isfinite(pattern_.distances(a, b))) {
          const double d = deviation(a, b);
          squares += d * d;
          way.worst = std::max(way.worst, std::abs(d));
          ++distances;
        }
      }
    }
    way.rms = distances > 0 ? std::sqrt(squares / distances) : 0.0;
  }

  const Pattern& pattern_;
  const std::vector<FoundPoint>& found_;
  std::vector<int> order_;   // of the pattern's points
  std::vector<int> now_;     // for each the found one
  std::vector<char> used_;   // found ones
  std::vector<int> wanted_;  // by hints
  int best_;
  long steps_ = 0;
  Matching matching_;
};

}  // namespace

Expected<Matching> match(const Pattern& pattern, const std::vector<FoundPoint>& found,
                         const std::vector<PlaceHint>& hints) {
  if (auto checked = check(pattern, hints); !checked) {
    return tl::unexpected(checked.error());
  }
  auto resolved = resolve_hints(pattern, found, hints);
  if (!resolved.unmet.empty()) {
    Matching matching;
    matching.unmet = std::move(resolved.unmet);
    return matching;
  }
  return pattern.radii.empty() || found.empty() ? Matching{}
                                                : DepthFirstSearch(pattern, found, std::move(resolved.found)).run();
}

}  // namespace artcal
