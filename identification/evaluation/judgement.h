#pragma once

#include <string>
#include <vector>

#include "identification/evaluation/goodness_of_fit.h"
#include "identification/identify.h"
#include "identification/least_squares/arm_fit.h"

namespace artcal {

/// Whether the residuals are as large as the noise says: writes noise, degrees of freedom, χ² and its limits, the
/// scale factor and a warning.
void judge_noise(const ArmFit& fit, const GoodnessOfFit& agreement, Identification& result);

/// No solution: errors that no joint has, since readings that hardly determine them let them run away.
Expected<void> check_joint_errors(const std::vector<IdentifiedParameter>& parameters);

/// Things that are no error but that a careful person would want to know; `length` is the arm's reach, mm.
std::vector<std::string> suspicions(const Identification& result, double length);

/// Parameters with a weak prior, because the readings hardly determine them: their state, and a warning.
void mark_weak(std::vector<std::string> names, Identification& result);

/// Why a fit with misfits (identification/evaluation/misfit.h) is refused: what they are, which readings are outliers
/// of an arm that fits all others (where there is such an arm), what to do. `where` names the places of these readings.
Error misfit_error(const std::vector<std::string>& misfits, int attempts, const std::vector<std::string>& where = {});

/// What was wrong with a fit that failed, where the arm that it began with shows it.
Error with_reason(Error error, const Recording& recording, const Constraints& constraints, const Arm& start);

}  // namespace artcal
