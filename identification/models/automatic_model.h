#pragma once

#include "identification/identify.h"

namespace artcal {

/// Identifies with as many groups of parameters as the readings speak for. Beginning with Denavit and Hartenberg's
/// parameters and the groups of options.model, each group that is not in yet is tried on its own; the best of those
/// that are worth it is taken, and so on until none is.
///
/// Worth it: let mp be the mean square of the deviations of the readings and the errors of the certified lengths of
/// placement p, judged by an arm identified without it, and Δp how much smaller it is with the group than before. The
/// improvement is Δ = Σ wp·Δp with wp the placement's share of the readings and lengths; its noise, from the scatter
/// of the placements, is s = √(P/(P−1)·Σ wp²·(Δp − Δ)²). A group is worth it where Δ > t·s, t being Student's quantile
/// with P − 1 degrees of freedom at 1 − 0.05/m for the m groups judged in this step (Bonferroni), one-sided. Readings
/// that a group was fitted to do not count for it, so that a useless group makes it worse.
///
/// The placements that chose the model also give Identification::left_out: of a model with groups taken that is a
/// lower bound rather than an estimate for new readings (Identification::left_out_chose_the_model).
///
/// All that was tried stands in Identification::trials. The errors are identify()'s; usage: fewer than three
/// placements, with which no noise can be determined, or options.leave_out not set.
Expected<Identification> identify_automatically(const Recording& recording, const Constraints& constraints,
                                                const IdentifyOptions& options);

}  // namespace artcal
