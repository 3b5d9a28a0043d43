#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// Adds P_Size, P_Form and L_Dia of every artefact that is a single ball, in each of its placements (the
/// positions of the ball; each is judged, so the worse counts). Readings without an orientation, or all of
/// one, are the 25 points; readings in several orientations are the articulated test.
///     P_Size  diameter of the least-squares sphere less the calibrated one
///     P_Form  range of its radial residuals
///     L_Dia   diameter of the minimum circumscribed sphere of the orientations' least-squares centres
/// What cannot be evaluated is told in `missing`.
void add_sphere_tests(const Session& session, Verification& verification);

/// Whether these tests are for this artefact.
bool is_single_ball(const Artefact& artefact);

}  // namespace artcal
