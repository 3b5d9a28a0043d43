#pragma once

#include "acquisition/recording/recording.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/models/model_study.h"

namespace artcal {

/// Searches a fit's residuals for unmodelled effects. Everything that was fitted (arm, places, certificates' errors) is
/// projected out of both the residuals and what they are searched for; the noise may differ from posture to posture and
/// be correlated within a reading (score_statistic()), so that each test has its nominal size. Each is made at
/// false_alarms/(number of tests) (Bonferroni). What was found joins the model, and the rest is searched again, so that
/// one cause is not found under several names.
///
/// Of more than 4,000 readings of points, or 12,000 on balls and planes, about so many are looked at, evenly taken.
/// `system` is make_system() at the arm of the fit.
ModelStudy search_residuals(const System& system, const ArmFit& fit, const Recording& recording);

}  // namespace artcal
