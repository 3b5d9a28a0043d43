#pragma once

#include <vector>

#include "artefacts/constraints/constraint.h"

namespace artcal {

/// Which certificate's number each of Constraints::distances is: counted over the distances of all artefacts, one after
/// the other.
std::vector<int> certified_distances(const Constraints& constraints);

/// How far each feature's artefact was above its reference temperature in the placement, K; 0 where nobody read it.
std::vector<double> above_reference(const Constraints& constraints, const Recording& recording);

}  // namespace artcal
