#pragma once

#include <cstdint>
#include <vector>

#include "fitting/fit.h"

namespace artcal {

struct RobustOptions {
  /// A point farther from the feature than this many standard deviations of the noise is an outlier; more of
  /// them where few points tell the noise (Student), so that the chance of losing a good one stays the same.
  double limit = 4.0;
  /// Largest share of the points that may be outliers; in (0, 0.5].
  double share = 0.5;
  /// Of the random subsets that are tried. The same seed and points give the same answer.
  std::uint64_t seed = 0;
};

template <typename F>
struct RobustFitted {
  Fitted<F> fitted;           ///< of the points kept; residuals of all of them, form and rms of those kept
  std::vector<int> outliers;  ///< the columns of the points left out, ascending
};

/// A least-squares fit of the points that belong to the feature, and the list of those that do not.
///
/// Subsets of as many points as the feature needs are fitted; the one from which `1 - share` of all points
/// have the smallest distance gives the scale of the noise (least median of squares; Rousseeuw, Leroy
/// 1987). Points beyond `limit` of it are left out, the rest fitted, and the noise and the list made
/// anew until the list stands. With FitOptions::noise that noise is the scale.
///
/// Errors as `fit`; NoSolution too where no subset makes a feature that more than half of the points agree
/// on. Criteria other than least squares, which listen to extremes only, are a Usage error.
template <typename F>
Expected<RobustFitted<F>> fit_robust(const Points& points, const FitOptions& options = {},
                                     const RobustOptions& robust = {});

extern template Expected<RobustFitted<Sphere>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
extern template Expected<RobustFitted<Plane>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
extern template Expected<RobustFitted<Line>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
extern template Expected<RobustFitted<Circle>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
extern template Expected<RobustFitted<Cylinder>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);
extern template Expected<RobustFitted<Cone>> fit_robust(const Points&, const FitOptions&, const RobustOptions&);

}  // namespace artcal
