#pragma once

#include <string>
#include <vector>

#include "identification/evaluation/evaluation.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/problem/loss.h"

namespace artcal {

/// Why a converged fit is no solution, in sentences; empty where it is one. Judged by chi-squared where the noise is
/// stated and by physics, never by comparing features with each other (all may be bad, or there may be one only):
/// - the residuals exceed ten times the stated noise and what errors that a model lacks can add to it (0.1 mrad at the
///   arm's reach, at least 0.1 mm) or, where no noise is stated, what any arm and probe can have: half a milliradian at
///   the arm's reach, at least 0.5 mm. With a robust loss the median of the residuals counts, so that
///   readings it lets go of do not;
/// - a certified distance, measured between features fitted each by itself, is off by twenty times its standard
///   uncertainty, that of its two ends included (not with a robust loss);
/// - a parameter moved from its nominal value by more than any arm's does: a tenth of the reach and at least 100 mm, or
///   30 degrees, of an encoder's zero 90.
std::vector<std::string> misfits(const ArmFit& fit, const Evaluation& after, const Arm& nominal,
                                 const std::vector<Parameter>& free, const Noise& noise, Loss loss);

/// What any arm and probe can have of noise at the arm's reach, mm a coordinate, where none is stated.
double largest_possible_noise(const Arm& nominal);

/// The rms of the whitened residuals of a fit, of a robust one by their median: 1 where they are as stated.
double noise_ratio(const ArmFit& fit, Loss loss);

/// Whether all free parameters are within those bounds of their nominal values.
bool is_plausible(const Arm& nominal, const Arm& identified, const std::vector<Parameter>& free);

}  // namespace artcal
