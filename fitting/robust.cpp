#include "fitting/robust.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "core/random.h"
#include "core/statistics.h"

namespace artcal {
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

constexpr Eigen::Index judged_points = 2000;  // a median over that many is as good as one over all

// The factor for few points is Rousseeuw and Leroy's.
double scale_of(double median_distance, Eigen::Index points, int parameters) {
  return sigma_per_median() * (1.0 + 5.0 / std::max<double>(1.0, static_cast<double>(points - parameters))) *
         median_distance;
}

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

Eigen::Matrix3Xd columns(const Points& points, const std::vector<int>& which) {
  Eigen::Matrix3Xd some(3, static_cast<Eigen::Index>(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i) {
    some.col(static_cast<Eigen::Index>(i)) = points.col(which[i]);
  }
  return some;
}

// The distance that a share of the points stays below.
template <typename F>
double distance_at(const F& feature, const Points& points, double share) {
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    distances.push_back(std::abs(signed_distance(feature, points.col(i))));
  }
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(distances.size() - 1));
  std::nth_element(distances.begin(), distances.begin() + rank, distances.end());
  return distances[static_cast<std::size_t>(rank)];
}

// Options of a plain fit: no tip yet, so that distances are those of the points as given.
FitOptions bare(const FitOptions& options) {
  FitOptions plain = options;
  plain.weights.resize(0);
  if (plain.fixed_radius) {
    *plain.fixed_radius += options.side == Side::Outside ? options.tip_radius : -options.tip_radius;
  }
  plain.tip_radius = 0.0;
  return plain;
}

template <typename F>
struct Candidate {
  F feature;
  double distance;
};

template <typename F>
std::optional<Candidate<F>> best_subset(const Points& points, const FitOptions& options, const RobustOptions& robust) {
  RandomStream random(robust.seed, "robust fit");
  const Eigen::Index judged = std::min(points.cols(), judged_points);
  const Eigen::Matrix3Xd jury = judged == points.cols()
                                    ? Eigen::Matrix3Xd(points)
                                    : columns(points, draw(random, static_cast<int>(judged), points.cols()));
  std::optional<Candidate<F>> best;
  const int size = std::min<int>(subset_size<F>, static_cast<int>(points.cols()));
  for (int trial = 0; trial < trials<F>; ++trial) {
    const auto subset = fit<F>(columns(points, draw(random, size, points.cols())), options);
    if (!subset) {
      continue;
    }
    const double distance = distance_at(subset->feature, jury, 1.0 - robust.share);
    if (!best || distance < best->distance) {
      best = Candidate<F>{subset->feature, distance};
    }
  }
  return best;
}

// The limit in standard deviations of a noise that the points themselves told: Student's quantile in place of
// the normal one, and for a point that is left out the doubt of the feature.
// Without it a few points lost by bad luck make the noise smaller and never come back.
double fair_limit(double limit, const FitOptions& options, int degrees_of_freedom, int parameters) {
  if (options.noise) {
    return limit;
  }
  const double freedom = std::max(1, degrees_of_freedom);
  return student_limit_as_rare_as(limit, freedom) * std::sqrt(1.0 + parameters / freedom);
}

template <typename F>
Eigen::VectorXd weights_within(const F& feature, const Points& points, const FitOptions& options, double limit) {
  Eigen::VectorXd weights =
      options.weights.size() == 0 ? Eigen::VectorXd(Eigen::VectorXd::Ones(points.cols())) : options.weights;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double worth = std::sqrt(weights(i));
    if (std::abs(signed_distance(feature, points.col(i))) * worth > limit) {
      weights(i) = 0.0;
    }
  }
  return weights;
}

std::vector<int> left_out(const Eigen::VectorXd& weights) {
  std::vector<int> indices;
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    if (weights(i) == 0.0) {
      indices.push_back(static_cast<int>(i));
    }
  }
  return indices;
}

Expected<void> check(const FitOptions& options, const RobustOptions& robust) {
  if (options.criterion != Criterion::LeastSquares) {
    return wrong_usage("a robust fit is a least-squares fit; fit robustly first and then the points it kept");
  }
  if (!(robust.limit > 0.0) || !(robust.share > 0.0 && robust.share <= 0.5)) {
    return wrong_usage(
        fmt::format("outliers beyond {} standard deviations and a share of {}: expected a limit above "
                    "zero and a share above zero, at most one half",
                    robust.limit, robust.share));
  }
  return {};
}

}  // namespace

template <typename F>
Expected<RobustFitted<F>> fit_robust(const Points& points, const FitOptions& options, const RobustOptions& robust) {
  if (auto checked = check(options, robust); !checked) {
    return tl::unexpected(checked.error());
  }
  // What is wrong with the points or the options is said by the plain fit, outliers or not.
  if (const auto plain = fit<F>(points, options); !plain && plain.error().code != ErrorCode::NoSolution) {
    return tl::unexpected(plain.error());
  }
  const auto best = best_subset<F>(points, bare(options), robust);
  if (!best) {
    return no_solution("no subset of the points determines the feature; are they all on one line or plane?");
  }
  const double floor = 64.0 * std::numeric_limits<double>::epsilon() * points.cwiseAbs().maxCoeff();
  double noise = options.noise.value_or(scale_of(best->distance, points.cols(), F::parameter_count));
  FitOptions kept = options;
  kept.weights = weights_within(best->feature, points, options, robust.limit * std::max(noise, floor));
  RobustFitted<F> result;
  constexpr int max_rounds = 50;
  for (int round = 0; round < max_rounds; ++round) {
    FitOptions surface = bare(options);
    surface.weights = kept.weights;
    const auto fitted = fit<F>(points, surface);
    if (!fitted) {
      return tl::unexpected(fitted.error());
    }
    noise = fitted->noise.value_or(noise);
    const double limit = fair_limit(robust.limit, options, fitted->degrees_of_freedom, F::parameter_count);
    const Eigen::VectorXd next = weights_within(fitted->feature, points, options, limit * std::max(noise, floor));
    const bool stands = next == kept.weights;
    kept.weights = next;
    if (stands) {
      break;
    }
  }
  auto fitted = fit<F>(points, kept);
  if (!fitted) {
    return tl::unexpected(fitted.error());
  }
  result.fitted = std::move(*fitted);
  result.outliers = left_out(kept.weights);
  return result;
}

template Expected<RobustFitted<Sphere>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
template Expected<RobustFitted<Plane>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
template Expected<RobustFitted<Line>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
template Expected<RobustFitted<Circle>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
template Expected<RobustFitted<Cylinder>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
template Expected<RobustFitted<Cone>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);

}  // namespace artcal
