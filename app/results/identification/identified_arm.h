#pragma once

#include "acquisition/arm/arm_identification.h"
#include "identification/identify.h"
#include "identification/uncertainty/uncertain_arm.h"

namespace artcal {

/// What an identification leaves in the arm's file. `options` are those it was made with; their noise by parts is kept
/// by its parts, enlarged as all uncertainties are.
ArmIdentification arm_identification(const Recording& recording, const IdentifyOptions& options,
                                     const Identification& result);

/// What makes an identified arm uncertain: the covariance of its parameters, and the noise of new readings as it is
/// known of those that it was identified from. Without any noise known it is zero.
UncertaintySources uncertainty_sources(const Arm& arm, const ArmIdentification& known);

}  // namespace artcal
