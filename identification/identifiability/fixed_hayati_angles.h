#pragma once

#include <string>

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "identification/evaluation/evaluation.h"
#include "identification/identify.h"

namespace artcal {

/// What an identification is to say where Hayati's angle of nearly parallel axes is fixed by request, which is the
/// model of Denavit and Hartenberg alone: which axes they are, and how well the readings are fitted without that
/// request, which is tried. Empty if no such angle is fixed. `after` is the evaluation of the arm identified with the
/// request.
std::string note_on_fixed_hayati_angles(const Recording& recording, const Constraints& constraints,
                                        const IdentifyOptions& options, const Evaluation& after);

/// Where no solution was found: the error, with the advice to free the angles if that leads to a solution.
Error with_fixed_hayati_angles(Error error, const Recording& recording, const Constraints& constraints,
                               const IdentifyOptions& options);

}  // namespace artcal
