#pragma once

#include <optional>

#include "fitting/robust/robust.h"

namespace artcal::fitting {

/// Options of a plain fit: no tip yet, so that distances are those of the points as given, and no weights.
FitOptions bare(const FitOptions& options);

/// How many points are sound at least, of `count` in which a share of `share` may not be. Least median of squares with
/// the highest breakdown point needs [n/2] + [(p + 1)/2] of them, where a feature passes through p (Rousseeuw, Leroy
/// 1987, ch. 3.4): with fewer, the points that it passes through are the agreement that is looked for.
Eigen::Index sound_points(Eigen::Index count, int through, double share);

/// The feature through a random subset of the points that has `sound` points of all within the smallest distance;
/// nothing where no subset makes a feature.
template <typename F>
std::optional<F> best_subset(const Points& points, const FitOptions& options, Eigen::Index sound, std::uint64_t seed);

}  // namespace artcal::fitting
