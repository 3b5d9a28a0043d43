#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "identification/inspection/finding.h"
#include "identification/models/model.h"

namespace artcal {

/// What a recording would be if one mistake had not been made.
struct Hypothesis {
  FindingKind kind = FindingKind::RepeatedReadings;
  /// Unknowns that it adds, in order of magnitude: 0 a choice among few, 1 a number, 2 a pose, 3 a table, 4 a
  /// placement left out. Of two that explain the readings equally well, the one that adds less is named.
  int complexity = 0;
  std::string where;
  std::string text;    ///< "read with q2 and q3 exchanged"
  std::string remedy;  ///< what to do, a sentence
  std::function<void(Recording&, std::vector<Artefact>&)> apply;
  Model model = {};  ///< groups of parameters that it adds
};

/// A recording and what its artefacts ask of it.
struct Bound {
  Recording recording;
  Constraints constraints;
};

/// The recording as the hypothesis has it; nothing where it cannot be bound to its artefacts then.
std::optional<Bound> applied(const Hypothesis& hypothesis, const Recording& recording,
                             const std::vector<Artefact>& artefacts);

/// The readings for which `keep` is true, with all labels.
template <typename Keep>
Recording readings_where(const Recording& recording, Keep keep) {
  Recording kept = recording;
  kept.readings.clear();
  Eigen::Index count = 0;
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    if (keep(static_cast<int>(i))) {
      kept.readings.push_back(recording.readings[i]);
      kept.joints.col(count++) = recording.joints.col(static_cast<Eigen::Index>(i));
    }
  }
  kept.joints.conservativeResize(Eigen::NoChange, count);
  return kept;
}

/// How far readings and certified lengths are from what `arm` makes of them, mm rms: of each feature fitted by itself,
/// and of the lengths between them. Infinite where features cannot be fitted.
double discrepancy(const Bound& bound, const Arm& arm);

/// "q2" for joint number 1, counted from 0.
std::string joint_name(int joint);

}  // namespace artcal
