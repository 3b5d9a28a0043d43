#pragma once

#include <string>
#include <vector>

#include "identification/evaluation/goodness_of_fit.h"
#include "identification/identify.h"

namespace artcal {

/// What to say where the residuals are larger or smaller than the stated noise; empty where they agree, and where no
/// noise was stated.
std::string warning_of(const GoodnessOfFit& goodness_of_fit, double scale_factor, const Noise& noise);

/// No solution: errors that no joint has, since readings that hardly determine them let them run away.
Expected<void> check_joint_errors(const std::vector<IdentifiedParameter>& parameters);

/// Things that are no error but that a careful person would want to know; `length` is the arm's reach, mm.
std::vector<std::string> suspicions(const Identification& result, double length);

/// What to say of parameters with a weak prior, of so many identified ones; empty where there are none.
std::string warning_of_weak_prior(const std::vector<std::string>& names, std::size_t identified);

/// Why a fit with misfits (identification/evaluation/misfit.h) is refused: what they are, which readings are outliers
/// of an arm that fits all others (where there is such an arm), what to do. `where` names the places of these readings.
/// ErrorKind::Misfit; Error::found is the message without general advice, Error::reason the first misfit.
Error misfit_error(const std::vector<std::string>& misfits, int attempts, const std::vector<std::string>& where = {});

/// What was wrong with a fit that failed, where the arm that it began with shows it: the error's reason, and a misfit
/// where it is an implausible feature.
Error with_reason(Error error, const Recording& recording, const Constraints& constraints, const Arm& start);

}  // namespace artcal
