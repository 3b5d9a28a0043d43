#pragma once

#include <vector>

#include "identification/inspection/hypotheses/hypothesis.h"

namespace artcal {

/// Lengths in another unit (inch, cm, m): of an artefact's file, of its distances alone, of the arm's file; positions
/// from the first feature stated as distances from one to the next.
std::vector<Hypothesis> length_hypotheses(const Recording& recording, const std::vector<Artefact>& artefacts);

/// A diameter stated as a radius, or a radius as a diameter: of each tip, and of the balls of each artefact.
std::vector<Hypothesis> radius_hypotheses(const Recording& recording, const std::vector<Artefact>& artefacts);

/// The radii of the tips as what the readings say (model group Radius), where balls of known diameter are read.
std::vector<Hypothesis> free_radius_hypotheses(const Constraints& constraints);

}  // namespace artcal
