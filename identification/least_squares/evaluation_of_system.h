#pragma once

#include "identification/evaluation/evaluation.h"
#include "identification/problem/system.h"

namespace artcal {

/// evaluate() for who has a system already: of its start arm; its free parameters do not matter.
Expected<Evaluation> evaluate(const System& system, const Recording& recording);

}  // namespace artcal
