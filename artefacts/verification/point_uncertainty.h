#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// Largest dilution of a single ball's centre or radius with which conformity is shown. Four touches on the equator and
/// one at the pole have 1.1, four at 60 degrees from the pole and one there 2.2; five within 39 degrees exceed it.
inline constexpr double max_dilution = 5.0;

/// Fills u(points) of every value, its dilution times the pooled scatter of one touch, and judges it with that. Balls
/// scatter about their fitted spheres, seats about their mean in one placement (all repeats), faces about their planes.
/// Where a kind of touch has no redundancy, the noise by which the arm was identified is taken. Notes as missing a
/// dilution beyond max_dilution and, where the decision rule needs u, a scatter that nothing determines; warns of a
/// dilution that makes most of u.
void add_point_uncertainties(const Session& session, Verification& verification);

}  // namespace artcal
