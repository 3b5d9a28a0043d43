#pragma once

#include <optional>
#include <string>
#include <vector>

#include "acquisition/arm/parameters.h"
#include "identification/least_squares/linearisation.h"
#include "identification/problem/system.h"

namespace artcal {

/// Standard deviations of what nominal arms are off by: the weak prior of coarse fits, and the bound beyond which a
/// direction that the readings determine worse is better fixed. Of a length mm, of an angle rad; 0 for joint errors.
double prior_deviation(const Parameter& parameter);

/// Weights of pseudo-observations x = 0 of a system's steps (SolveOptions::prior_weights).
Eigen::VectorXd prior_weights(const std::vector<Parameter>& free, const Eigen::VectorXd& scale);
inline Eigen::VectorXd prior_weights(const System& system) { return prior_weights(system.free, system.scale); }

/// An arm fitted under the prior, and the parameters that the readings determine worse than the prior does.
struct WeakParameters {
  Arm arm;
  std::vector<std::string> names;
  bool scale_is_weak = false;  ///< see is_scale_weak()
};

/// Whether the readings determine the growth of all lengths in proportion worse than to 0.4 %
/// (standard uncertainty): `linearisation` is that of a fit without prior, at `arm`, its weights being those of the
/// noise.
bool is_scale_weak(const Arm& arm, const std::vector<Parameter>& free, const Linearisation& linearisation,
                   const Eigen::VectorXd& scale);

/// Fits the free parameters from `start` with the prior about it, which converges where a direction is hardly
/// determined, and takes the singular values of the readings' own system there, each column in units of its prior's
/// standard deviation. Each direction with a standard uncertainty above 1 is named by one
/// parameter: a length of an outer joint (a, then d, from the last joint inwards) where it takes a
/// good part in the direction, since the founding paper fixes a6 and d6, else the parameter with the largest part.
/// Nothing where the fit fails.
std::optional<WeakParameters> find_weak_parameters(const Recording& recording, const Constraints& constraints,
                                                   const Arm& start, const std::vector<Parameter>& free,
                                                   const Noise& noise);

}  // namespace artcal
