#pragma once

#include <cstdint>
#include <vector>

#include "fitting/fit.h"

namespace artcal {

struct RobustOptions {
  /// A sound point is lost as rarely as a normal variable is beyond this many standard deviations. Where few
  /// points tell the noise the limit itself is wider (Student).
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
/// Subsets of as many points as the feature needs are fitted; the one that most points are near to (least median of
/// squares; Rousseeuw, Leroy 1987) is where a forward search starts (Hadi, Simonoff 1993): the nearest point is added
/// and the feature fitted anew, until the nearest of the others is farther than chance explains. With
/// FitOptions::noise that noise is the scale. Equal points are one point. docs/fitting.md says what few points prove.
///
/// Errors as `fit`; BadInput too where so few points differ that none could be told from the rest, NoSolution where no
/// subset makes a feature. Criteria other than least squares, which listen to extremes only, are a Usage error.
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
