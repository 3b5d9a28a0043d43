#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// Adds the error of every certified length between two parallel faces (gauge block, step gauge) that were both read in
/// the same placement and repeat, be it in a single point each. The direction n is that of face_axis. With σ = ±1 for a
/// face that looks along the way from the first to the second face or against it, and the tip's radius r:
///     L = |n·(mean₂ − mean₁)| − r·(σ₂ − σ₁).
/// Faces that look the same way count as E_Uni, others as E_Bi. Which way they look is told by the certified normals; a
/// gauge block's look away from each other. Where no distances are certified, the lengths are those between all pairs
/// of faces with certified coordinates. u(align) is the specification's and what the direction's own uncertainty u
/// makes of the points' distance d across it, √((d·u)² + (L·u²/2)²). What cannot be evaluated is told in `missing`.
void add_face_tests(const Session& session, Verification& verification);

}  // namespace artcal
