#pragma once

#include <optional>
#include <string>

#include "identification/evaluation/evaluation.h"

namespace artcal {

/// What is so far from its place, mm, and from what is usual is no reading of what it is said to be.
inline constexpr double another_place = 2.0;

/// A feature whose readings fit an arm far worse than the others' do, in words: rms above `far_off` (mm), five times
/// the median, and more than chance makes of the worst of so many features of so few readings. The wrong ball was read,
/// or in another place than the rest, or some readings are another feature's.
std::optional<std::string> implausible_feature(const Evaluation& evaluation, double far_off);

/// The same, else a certified distance that stands out so, against the uncertainties of its certified value and of its
/// two ends, each fitted by itself: features have each other's names.
std::optional<std::string> implausible_feature_text(const Evaluation& evaluation, double far_off);

/// Of certified distances that an arm measures more than a tenth off, median over placements, the one that is off most:
/// no nominal arm is so wrong, but a certificate that was copied wrongly is (positions given as steps, another unit).
std::optional<std::string> grossly_different_length(const Evaluation& evaluation);

}  // namespace artcal
