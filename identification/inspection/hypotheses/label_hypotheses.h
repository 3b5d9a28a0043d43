#pragma once

#include <vector>

#include "identification/inspection/hypotheses/hypothesis.h"

namespace artcal {

/// What may be wrong with the labels of one placement's readings (`placement` into Recording::placements): two features
/// exchanged, one feature's readings under another's name.
std::vector<Hypothesis> feature_hypotheses(const Recording& recording, const Constraints& constraints, int placement);

/// The artefact moved within the placement: from some reading on (the best by `arm`, which the other placements fit)
/// its readings are of another pose. Features with fewer than four readings on one side of the move are left out there.
std::vector<Hypothesis> move_hypotheses(const Recording& recording, const Constraints& constraints, int placement,
                                        const Arm& arm);

/// Placement names that occur in several tables are different placements; nothing where none does.
std::vector<Hypothesis> table_name_hypotheses(const Recording& recording);

/// One of several tables, with half of the readings at most, was read by another arm or in another state: the recording
/// without it.
std::vector<Hypothesis> other_table_hypotheses(const Recording& recording);

/// The recording without a placement.
Hypothesis without_placement(const Recording& recording, int placement);

/// The readings of one placement by themselves.
Recording readings_of_placement(const Recording& recording, int placement);

}  // namespace artcal
