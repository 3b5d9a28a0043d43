#pragma once

#include <vector>

#include "app/report/sheet.h"
#include "app/results/evaluation/recorded_evaluation.h"

namespace artcal {

/// The certified lengths of an identification, each measured and not fitted: table and picture.
/// REQUIRES: `before` and `after` have the same lengths in the same order.
void write_length_errors(const RecordedEvaluation& before, const RecordedEvaluation& after,
                         const std::vector<RecordedLeftOut>& left_out, Sheet& sheet);

}  // namespace artcal
