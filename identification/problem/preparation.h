#pragma once

#include <vector>

#include "identification/identify.h"
#include "identification/initial/initial_alignment.h"

namespace artcal {

/// What is known before anything is solved.
struct Preparation {
  Arm start;
  Coupling coupling;
  std::vector<Parameter> free;
};

/// The start after an initial alignment, and of the parameters asked for those that these readings determine there.
/// Usage: a model that makes no sense for this arm, or names that it does not have. No solution: the alignment failed,
/// the scale is unidentifiable, or nothing is left to identify; see also analyse_coupling() and arm_with_fitted_tips().
/// The alignment begins at the nominal arm, or at `from`.
Expected<Preparation> prepare(const Recording& recording, const Constraints& constraints,
                              const IdentifyOptions& options, Alignment alignment, const Arm* from = nullptr);

/// The same with a known arm for a start: one that was identified with these readings and others.
Expected<Preparation> prepare_from(const Arm& start, const Recording& recording, const Constraints& constraints,
                                   const IdentifyOptions& options);

}  // namespace artcal
