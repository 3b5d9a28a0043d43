#pragma once

#include <vector>

#include "identification/identify.h"
#include "identification/least_squares/arm_fit.h"

namespace artcal {

/// How much each artefact counts in a fit, as Constraints::artefacts; those that nothing was read of are absent.
std::vector<ArtefactInfluence> influences_of(const Constraints& constraints, const ArmFit& fit,
                                             const Redundancy& redundancy);

}  // namespace artcal
