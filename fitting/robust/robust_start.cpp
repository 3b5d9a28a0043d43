#include "fitting/robust/robust_start.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "core/random.h"
#include "fitting/chosen_points.h"

namespace artcal::fitting {
namespace {

// Points of a subset and how many subsets. Features with an axis get more points than they need: from the
// fewest, several different surfaces pass through, and each trial costs a search for the axis.
template <typename F>
constexpr int subset_size = std::is_same_v<F, Line>       ? 2
                            : std::is_same_v<F, Sphere>   ? 4
                            : std::is_same_v<F, Cylinder> ? 7
                            : std::is_same_v<F, Cone>     ? 9
                                                          : 3;
template <typename F>
constexpr int trials = std::is_same_v<F, Cylinder> || std::is_same_v<F, Cone> ? 300 : 500;

constexpr Eigen::Index judged_points = 2000;  // a quantile over that many is as good as one over all

// Different columns, drawn without replacement (Floyd).
std::vector<int> draw(RandomStream& random, int size, Eigen::Index count) {
  std::vector<int> picked;
  for (Eigen::Index j = count - size; j < count; ++j) {
    const int pick = static_cast<int>(random.uniform() * static_cast<double>(j + 1));
    const bool known = std::find(picked.begin(), picked.end(), pick) != picked.end();
    picked.push_back(known ? static_cast<int>(j) : pick);
  }
  return picked;
}

// The distance that `share` of the points stay within.
template <typename F>
double distance_at(const F& feature, const Points& points, double share) {
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    distances.push_back(std::abs(signed_distance(feature, points.col(i))));
  }
  const auto rank = std::max<std::ptrdiff_t>(std::lround(share * static_cast<double>(distances.size())), 1) - 1;
  std::nth_element(distances.begin(), distances.begin() + rank, distances.end());
  return distances[static_cast<std::size_t>(rank)];
}

}  // namespace

FitOptions bare(const FitOptions& options) {
  FitOptions plain = options;
  plain.weights.resize(0);
  if (plain.fixed_radius) {
    *plain.fixed_radius += options.side == Side::Outside ? options.tip_radius : -options.tip_radius;
  }
  plain.tip_radius = 0.0;
  return plain;
}

Eigen::Index sound_points(Eigen::Index count, int through, double share) {
  const auto wrong = static_cast<Eigen::Index>(share * static_cast<double>(count));
  return std::min(count, std::max(count / 2 + (through + 1) / 2, count - wrong));
}

template <typename F>
std::optional<F> best_subset(const Points& points, const FitOptions& options, Eigen::Index sound, std::uint64_t seed) {
  RandomStream random(seed, "robust fit");
  const Eigen::Index judged = std::min(points.cols(), judged_points);
  const Eigen::Matrix3Xd jury = judged == points.cols()
                                    ? Eigen::Matrix3Xd(points)
                                    : chosen_points(points, draw(random, static_cast<int>(judged), points.cols()));
  const double share = static_cast<double>(sound) / static_cast<double>(points.cols());
  std::optional<F> best;
  double best_distance = 0.0;
  const int size = std::min<int>(subset_size<F>, static_cast<int>(points.cols()));
  for (int trial = 0; trial < trials<F>; ++trial) {
    const auto subset = fit<F>(chosen_points(points, draw(random, size, points.cols())), options);
    if (!subset) {
      continue;
    }
    const double distance = distance_at(subset->feature, jury, share);
    if (!best || distance < best_distance) {
      best = subset->feature;
      best_distance = distance;
    }
  }
  return best;
}

template std::optional<Sphere> best_subset(const Points&, const FitOptions&, Eigen::Index, std::uint64_t);
template std::optional<Plane> best_subset(const Points&, const FitOptions&, Eigen::Index, std::uint64_t);
template std::optional<Line> best_subset(const Points&, const FitOptions&, Eigen::Index, std::uint64_t);
template std::optional<Circle> best_subset(const Points&, const FitOptions&, Eigen::Index, std::uint64_t);
template std::optional<Cylinder> best_subset(const Points&, const FitOptions&, Eigen::Index, std::uint64_t);
template std::optional<Cone> best_subset(const Points&, const FitOptions&, Eigen::Index, std::uint64_t);

}  // namespace artcal::fitting
