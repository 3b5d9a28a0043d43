#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// Adds the error of every certified length between two parallel faces (gauge block, step gauge) that were
/// both read in the same placement and repeat. The direction is the common normal of all faces read there, so
/// that they need readings off one line. With σ = ±1 for a face that looks along the way from the first to the
/// second face or against it, and the tip's radius r:
///     L = |n·(mean₂ − mean₁)| − r·(σ₂ − σ₁).
/// Faces that look the same way count as E_Uni, others as E_Bi. Which way they look is told by the certified
/// normals; a gauge block's look away from each other. What cannot be evaluated is told in `missing`.
void add_face_tests(const Session& session, Verification& verification);

}  // namespace artcal
