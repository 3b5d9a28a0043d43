#pragma once

namespace artcal::fitting {

/// The points that a fit leaves out, as far as chance is concerned.
struct LeftOutPoints {
  int points = 0;                   ///< in all
  int left_out = 0;                 ///< of these; at least 1
  int dimensions = 1;               ///< of a point's residual: 2 for a line or a circle in space
  double degrees_of_freedom = 0.0;  ///< of the noise, from the points kept; infinite: the noise is known
};

/// Whether chance does not explain that all points left out are at least `distance` standard deviations of a new point
/// away from the fit of those kept. `chance` is how rarely one sound point may be lost.
///
/// The noise of the points kept is itself uncertain, and they may have been chosen because they agree: of n points,
/// C(n, k) subsets lack k. A set of k outliers is accepted where
///     P(a given one is that far) ≤ chance   and   C(n, k)·P(k given ones are all that far) ≤ n·chance,
/// each the mean over the noise's χ distribution (Bonferroni). With k = 1 both are Student's test of the externally
/// studentised residual.
bool are_outliers(double distance, const LeftOutPoints& left_out, double chance);

}  // namespace artcal::fitting
