#pragma once

#include <vector>

#include "identification/inspection/hypotheses/hypothesis.h"

namespace artcal {

/// Joint angles in the other unit, two columns exchanged, all in reverse order or shifted by one, a joint that counts
/// the other way: for the whole recording and, where there are several, for each of its tables.
std::vector<Hypothesis> joint_hypotheses(const Recording& recording);

/// One joint whose zero is another, the best angle for each joint by the nominal arm; where that is 10 degrees or more.
std::vector<Hypothesis> offset_hypotheses(const Recording& recording, const Constraints& constraints);

}  // namespace artcal
