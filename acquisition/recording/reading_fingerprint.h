#pragma once

#include <string>
#include <vector>

#include "acquisition/recording/recording.h"

namespace artcal {

/// More fingerprints than this are not kept in an arm's file.
inline constexpr std::size_t max_fingerprints = 4096;

/// Twelve hexadecimal digits that stand for one reading's joint angles: the beginning of the SHA-256 of the angles in
/// whole microradians (0.2″), so that the same reading has the same fingerprint in a table of another unit or order.
/// Two independent touches of an arm do not agree in all joints to that. Empty where a joint was not read.
std::string reading_fingerprint(const Eigen::Ref<const Eigen::VectorXd>& joints);

/// Those of all readings and of `earlier` together, sorted, each once. Where there are more than max_fingerprints, the
/// lowest of them: which those are is random, so that they are a fair sample of the readings (a bottom-k sketch; Broder
/// 1997) and a table that shares many readings with this one shares some of the sample.
std::vector<std::string> fingerprints_of(const Recording& recording, const std::vector<std::string>& earlier);

/// How many readings of `recording` are among these (sorted). Where `known` is a sample it is a lower bound.
int count_known(const Recording& recording, const std::vector<std::string>& known);

}  // namespace artcal
