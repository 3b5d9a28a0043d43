#pragma once

#include "artefacts/constraints/constraint.h"
#include "core/error.h"

namespace artcal {

/// The arm to linearise at and to begin with: `nominal`, but with the tips stated as lx, ly, lz (known
/// roughly, found by calibration) moved to where the readings have them, all else held. A tip exactly on
/// the last axis is a special place at which more is unidentifiable than anywhere near it, so that the rank there
/// would say less than the readings can tell. Tips that the readings do not show well are left alone.
Expected<Arm> arm_with_fitted_tips(const Recording& recording, const Constraints& constraints, const Arm& nominal,
                                   const std::vector<std::string>& fixed);

}  // namespace artcal
