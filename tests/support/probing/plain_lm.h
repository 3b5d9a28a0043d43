#pragma once

#include "tests/support/probing/session.h"

namespace artcal::probing {

/// What any textbook does from the nominal arm: Levenberg–Marquardt on all unknowns at once, each ball's centre begun
/// at the linear fit to its readings. For sessions of balls and seats; written for the study, shares nothing with the
/// library. Returns the arm it ends at, whatever that is.
bool plain_lm_knows(const Session& session);
Chain plain_lm(const Session& session, double noise);

}  // namespace artcal::probing
