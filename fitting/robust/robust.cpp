#include "fitting/robust/robust.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "core/large_pages.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "fitting/bounding_box.h"
#include "fitting/chosen_points.h"
#include "fitting/distance_gradient.h"
#include "fitting/known.h"
#include "fitting/outlier_test.h"
#include "fitting/robust/distinct_points.h"
#include "fitting/robust/robust_start.h"

namespace artcal {
namespace {

using namespace fitting;

// Of a point's residual, as the noise is counted. A circle of metrology's convention has two fits, each with a noise of
// its own: of the plane and, in it, of the circle.
template <typename F>
int dimensions(const FitOptions& options) {
  const bool spatial = std::is_same_v<F, Circle> && options.circle == CircleConvention::Spatial;
  return std::is_same_v<F, Line> || spatial ? 2 : 1;
}

template <typename F>
int determined_numbers(const FitOptions& options) {
  return std::is_same_v<F, Line> || std::is_same_v<F, Circle> ? dimensions<F>(options) * Known<F>::requirement.points
                                                              : requirement_for<F>(options).points;
}

// With that many degrees of freedom the noise is known well enough to judge all points at once.
constexpr int plenty = 100;
constexpr int max_rounds = 50;
// Beyond, the search begins among some of the points.
constexpr Eigen::Index many_points = 50'000;
constexpr Eigen::Index searched_points = 10'000;

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

/// Which points a fit keeps, and how far each is from it.
template <typename F>
class Search {
 public:
  Search(const Points& points, const Eigen::VectorXd& weights, const FitOptions& options, double limit)
      : points_(points),
        weights_(weights),
        options_(bare(options)),
        dimensions_(dimensions<F>(options)),
        chance_(std::erfc(limit / std::sqrt(2.0))),
        floor_(64.0 * std::numeric_limits<double>::epsilon() * bounding_box(points_).largest_coordinate()),
        kept_(static_cast<std::size_t>(points_.cols()), false) {}

  std::vector<bool> from(const F& start, Eigen::Index sound) {
    if (points_.cols() <= many_points || !begin_with_some(start, sound)) {
      begin_with_all(start, sound);
    }
    const auto most = points_.cols() + max_rounds;
    for (Eigen::Index round = 0; round < most && grow(); ++round) {
    }
    return kept_;
  }

 private:
  void begin_with_all(const F& start, Eigen::Index sound) {
    distances_.clear();
    for (Eigen::Index i = 0; i < points_.cols(); ++i) {
      distances_.push_back(std::abs(signed_distance(start, points_.col(i))) * std::sqrt(weight(i)));
    }
    keep_nearest(sound);
    concentrate(sound);
  }

  // The search among points evenly taken, whose fit says which of all are kept first (Rousseeuw, Van Driessen 1999,
  // §3.3): false where it has no fit that can judge.
  bool begin_with_some(const F& start, Eigen::Index sound) {
    const Eigen::Index count = points_.cols();
    std::vector<int> some;
    for (Eigen::Index i = 0; i < searched_points; ++i) {
      some.push_back(static_cast<int>(i * count / searched_points));
    }
    const Eigen::Matrix3Xd points = chosen_points(points_, some);
    const Eigen::VectorXd weights = weights_.size() == 0 ? Eigen::VectorXd() : Eigen::VectorXd(weights_(some));
    Search coarse(points, weights, options_, chance_, dimensions_);
    coarse.from(start, (searched_points * sound + count - 1) / count);
    const auto fitted = coarse.fit_kept();
    if (!fitted || fitted->degrees_of_freedom < plenty) {
      return false;
    }
    distances_ = large_vector<double>(kept_.size());
    standardise(*fitted);
    keep_all_within(fitted->degrees_of_freedom);
    return true;
  }

  Search(const Points& points, const Eigen::VectorXd& weights, const FitOptions& options, double chance, int dimensions)
      : points_(points),
        weights_(weights),
        options_(options),
        dimensions_(dimensions),
        chance_(chance),
        floor_(64.0 * std::numeric_limits<double>::epsilon() * bounding_box(points_).largest_coordinate()),
        kept_(static_cast<std::size_t>(points_.cols()), false) {}

  [[nodiscard]] Eigen::Index kept_count() const { return std::count(kept_.begin(), kept_.end(), true); }

  [[nodiscard]] double weight(Eigen::Index i) const { return weights_.size() == 0 ? 1.0 : weights_(i); }

  [[nodiscard]] Expected<Fitted<F>> fit_kept() const {
    FitOptions options = options_;
    if (points_.cols() > many_points && weights_.size() == 0) {
      return fit<F>(points_where(points_, [&](std::size_t i) { return kept_[i]; }), options);
    }
    options.weights = weights_.size() == 0 ? Eigen::VectorXd(Eigen::VectorXd::Ones(points_.cols())) : weights_;
    for (Eigen::Index i = 0; i < points_.cols(); ++i) {
      options.weights(i) *= kept_[static_cast<std::size_t>(i)] ? 1.0 : 0.0;
    }
    return fit<F>(points_, options);
  }

  void keep_nearest(Eigen::Index count) {
    if (count <= 0) {
      kept_.assign(kept_.size(), false);
      return;
    }
    auto nearest = distances_;
    const auto last = nearest.begin() + (count - 1);
    std::nth_element(nearest.begin(), last, nearest.end());
    const double farthest = *last;
    // Of equal distances those of the first points.
    auto equal = count - std::count_if(nearest.begin(), last, [&](double distance) { return distance < farthest; });
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      kept_[i] = distances_[i] < farthest || (distances_[i] == farthest && equal-- > 0);
    }
  }

  // Least trimmed squares from there (the C-steps of Rousseeuw, Van Driessen 1999).
  void concentrate(Eigen::Index sound) {
    for (int step = 0; step < max_rounds; ++step) {
      const auto fitted = fit_kept();
      if (!fitted) {
        return;
      }
      for (Eigen::Index i = 0; i < points_.cols(); ++i) {
        distances_[static_cast<std::size_t>(i)] =
            std::abs(signed_distance(fitted->feature, points_.col(i))) * std::sqrt(weight(i));
      }
      const auto before = kept_;
      keep_nearest(sound);
      if (kept_ == before) {
        return;
      }
    }
  }

  // How far a point is in standard deviations of what the fit of the points kept foretells: a point of it pulled the
  // fit towards itself, for another the feature is uncertain beside the noise.
  [[nodiscard]] double standardised(double distance, const DistanceGradient<F>& gradient, const Fitted<F>& fitted,
                                    double noise, std::size_t i) const {
    const double own = noise * noise / weight(static_cast<Eigen::Index>(i));
    const double feature = fitted.covariance ? gradient.dot(*fitted.covariance * gradient) : 0.0;
    const double variance = kept_[i] ? std::max(own - feature, 1e-6 * own) : own + feature;
    return std::abs(distance) / std::sqrt(variance);
  }

  void standardise(const Fitted<F>& fitted) {
    const double noise = std::max(fitted.noise.value_or(0.0), floor_);
    constexpr std::size_t block_size = std::size_t{1} << 14u;
    parallel_blocks(distances_.size(), block_size, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Eigen::Vector3d p = points_.col(static_cast<Eigen::Index>(i));
        distances_[i] =
            standardised(signed_distance(fitted.feature, p), distance_gradient(fitted.feature, p), fitted, noise, i);
      }
    });
    if constexpr (std::is_same_v<F, Circle>) {
      if (options_.circle == CircleConvention::Projected) {
        standardise_projected(fitted, noise);
      }
    }
  }

  // The worse of both, each by its own noise: in the plane and out of it.
  void standardise_projected(const Fitted<Circle>& fitted, double noise) {
    const Circle& circle = fitted.feature;
    double squares = 0.0;
    for (std::size_t i = 0; i < distances_.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      squares += kept_[i] ? weight(k) * std::pow(circle.normal.dot(points_.col(k) - circle.centre), 2) : 0.0;
    }
    const double out_of_plane =
        std::max(options_.noise.value_or(std::sqrt(squares / std::max(1, fitted.degrees_of_freedom))), floor_);
    for (std::size_t i = 0; i < distances_.size(); ++i) {
      const Eigen::Vector3d way = points_.col(static_cast<Eigen::Index>(i)) - circle.centre;
      const Eigen::Vector3d across = (way - circle.normal.dot(way) * circle.normal).normalized();
      DistanceGradient<Circle> radial, axial;
      radial << -across, Eigen::Vector3d::Zero(), -1.0;
      axial << -circle.normal, way, 0.0;
      distances_[i] = std::max(
          standardised(radial_distance(circle, points_.col(static_cast<Eigen::Index>(i))), radial, fitted, noise, i),
          standardised(circle.normal.dot(way), axial, fitted, out_of_plane, i));
    }
  }

  // One step of the forward search of Hadi, Simonoff 1993; false: those kept stay.
  bool grow() {
    const Eigen::Index count = kept_count();
    if (count == points_.cols()) {
      return false;
    }
    const auto fitted = fit_kept();
    if (!fitted) {
      keep_nearest(count + 1);
      return true;
    }
    standardise(*fitted);
    return fitted->degrees_of_freedom >= plenty ? keep_all_within(fitted->degrees_of_freedom)
                                                : keep_one_more(count, fitted->degrees_of_freedom);
  }

  [[nodiscard]] double freedom(int degrees_of_freedom) const {
    return options_.noise ? std::numeric_limits<double>::infinity() : degrees_of_freedom;
  }

  bool keep_all_within(int degrees_of_freedom) {
    const double limit =
        std::sqrt(options_.noise ? chi_squared_quantile(1.0 - chance_, dimensions_)
                                 : dimensions_ * f_quantile_above(chance_, dimensions_, degrees_of_freedom));
    const auto before = kept_;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      kept_[i] = distances_[i] <= limit;
    }
    return kept_ != before && ++wide_rounds_ < max_rounds;
  }

  bool keep_one_more(Eigen::Index count, int degrees_of_freedom) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      nearest = kept_[i] ? nearest : std::min(nearest, distances_[i]);
    }
    const auto all = static_cast<int>(points_.cols());
    if (are_outliers(nearest, {all, all - static_cast<int>(count), dimensions_, freedom(degrees_of_freedom)},
                     chance_)) {
      return false;
    }
    keep_nearest(count + 1);
    return true;
  }

  const Points points_;
  const Eigen::VectorXd& weights_;  // none: all are one
  FitOptions options_;
  int dimensions_;
  double chance_;
  double floor_;
  std::vector<bool> kept_;
  std::vector<double> distances_;
  int wide_rounds_ = 0;
};

// The points that are needed to say of one that it does not belong: the others must determine the feature and have
// something left over to judge it by.
template <typename F>
Expected<void> check_count(const DistinctPoints& distinct, const FitOptions& options) {
  const int each = dimensions<F>(options);
  const int left_over = options.noise ? 1 : 2;
  const int needed = 1 + (determined_numbers<F>(options) + left_over + each - 1) / each;
  if (distinct.points().cols() >= needed) {
    return {};
  }
  return bad_input(fmt::format(
      "outliers among the points of a {} can be found from {} different points on, here are {}: fit all of them "
      "without looking for outliers, or take more",
      Known<F>::requirement.feature, needed, distinct.points().cols()));
}

// Which points do not belong, in their order. What the search needs is gone when the others are fitted.
template <typename F>
Expected<std::vector<int>> find_outliers(const Points& points, const FitOptions& options, const RobustOptions& robust) {
  const DistinctPoints distinct(points, options.weights);
  if (auto enough = check_count<F>(distinct, options); !enough) {
    return tl::unexpected(enough.error());
  }
  const int through = requirement_for<F>(options).points;
  const Eigen::Index sound = sound_points(distinct.points().cols(), through, robust.share);
  const auto start = best_subset<F>(distinct.points(), bare(options), sound, robust.seed);
  if (!start) {
    return no_solution("no subset of the points determines the feature; are they all on one line or plane?");
  }
  const std::vector<bool> kept =
      Search<F>(distinct.points(), distinct.weights(), options, robust.limit).from(*start, sound);
  std::vector<int> outliers;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const int which = distinct.of(static_cast<std::size_t>(i));
    if (which >= 0 && !kept[static_cast<std::size_t>(which)]) {
      outliers.push_back(static_cast<int>(i));
    }
  }
  return outliers;
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
  auto outliers = find_outliers<F>(points, options, robust);
  if (!outliers) {
    return tl::unexpected(outliers.error());
  }
  FitOptions last = options;
  if (!outliers->empty()) {
    last.weights =
        options.weights.size() == 0 ? Eigen::VectorXd(Eigen::VectorXd::Ones(points.cols())) : options.weights;
    last.weights(*outliers).setZero();
  }
  auto fitted = fit<F>(points, last);
  if (!fitted) {
    return tl::unexpected(fitted.error());
  }
  return RobustFitted<F>{std::move(*fitted), std::move(*outliers)};
}

template Expected<RobustFitted<Sphere>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
template Expected<RobustFitted<Plane>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
template Expected<RobustFitted<Line>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
template Expected<RobustFitted<Circle>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
template Expected<RobustFitted<Cylinder>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
template Expected<RobustFitted<Cone>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);

}  // namespace artcal
