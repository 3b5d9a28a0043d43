#pragma once

#include <optional>
#include <vector>

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "identification/identifiability/selection.h"
#include "identification/initial/alignment.h"

namespace artcal {

/// The alignments to try for these constraints at this arm, the most promising first. None is the first where the arm
/// sees every ball as round (rms deviation below 3 % of the radii), and where there are no balls.
std::vector<Alignment> alignments_for(const Recording& recording, const Constraints& constraints, const Arm& arm);

/// The arm after a coarse alignment and a first fit to the spheres; nothing where the numbers broke down.
///
/// A ball touched from one side has a mirror image that fits its readings nearly as well where the arm misses by a good
/// part of the ball's radius. The coarse fit therefore takes the centres for points, which have one solution only: they
/// lie where the stylus points to, as far as it points at the ball, or at the tip, if it does not. The tip is fixed
/// meanwhile (a stylus that points at the centre would answer with a longer tip), and each chain parameter has a prior
/// about its nominal value (10 mm, 3 degrees), because centres known to some millimetres do not determine all of them.
/// The fit to the spheres then begins at the centres found, all parameters free under the same prior, and goes on with
/// a loss that narrows from 1 mm to 0.3 mm where a ball is still not seen as round.
/// What `selection` fixes stays fixed, and so does what the centres alone do not determine.
std::optional<Arm> align(Alignment alignment, const Recording& recording, const Constraints& constraints,
                         const Arm& start, const Selection& selection);

}  // namespace artcal
