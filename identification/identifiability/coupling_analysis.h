#pragma once

#include <optional>

#include "identification/identifiability/coupling.h"
#include "identification/least_squares/linearisation.h"

namespace artcal {

/// A coupling analysis and the linearisation behind it, whose columns are Coupling::parameters, where that
/// is the linearisation of the readings as they are: a solver that starts at the same arm may begin with
/// it. It is not where readings were moved or points shifted for the analysis.
struct CouplingAnalysis {
  Coupling coupling;
  std::optional<Linearisation> as_read;
};

Expected<CouplingAnalysis> analyse(const Recording& recording, const Constraints& constraints, const Arm& arm,
                                   const CouplingOptions& options);

}  // namespace artcal
