#pragma once

#include <string>

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "identification/evaluation/evaluation.h"
#include "identification/identify.h"

namespace artcal {

/// Which neighbouring axes of the arm are nearly parallel without Hayati's angle between them, such as
/// "axes 2 and 3 (0.06 deg)"; empty if none are. Denavit and Hartenberg's parameters change without bound there.
std::string parallel_axes(const Arm& arm);

/// What an identification without the group `hayati` is to say of an arm with nearly parallel axes: which they are, and
/// how well the readings are fitted with `--model dh+hayati`, which is tried. Empty if there are none, or if the model
/// has the group or is chosen automatically. `after` is the evaluation of the arm identified without it.
std::string note_on_parallel_axes(const Recording& recording, const Constraints& constraints,
                                  const IdentifyOptions& options, const Evaluation& after);

/// Where no solution was found: the error, with the advice to use the group `hayati` if the arm has such axes and there
/// is a solution with the group.
Error with_parallel_axes(Error error, const Recording& recording, const Constraints& constraints,
                         const IdentifyOptions& options);

}  // namespace artcal
