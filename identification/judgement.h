#pragma once

#include <string>
#include <vector>

#include "identification/arm_fit.h"
#include "identification/identify.h"

namespace artcal {

/// Whether the residuals are as large as the noise says: writes noise, degrees of freedom, χ² and its limits, the
/// enlargement and a warning.
void judge_noise(const ArmFit& fit, Identification& result);

/// No solution: errors that no joint has, since readings that hardly tell them let them run away.
Expected<void> check_joint_errors(const std::vector<IdentifiedParameter>& parameters);

/// Things that are no error but that a careful person would want to know; `length` is the arm's reach, mm.
std::vector<std::string> suspicions(const Identification& result, double length);

/// One feature in another's place spoils the arm, unless a loss let go of it: no solution, with its name.
Expected<void> check_places(const Evaluation& after, Loss loss);

/// What was wrong with a fit that failed, where the arm that it began with shows it.
Error with_reason(Error error, const Recording& recording, const Constraints& constraints, const Arm& start);

}  // namespace artcal
