#pragma once

#include <vector>

#include "identification/estimation.h"

namespace artcal {

/// What a model is chosen by: the estimate, and what placements say that it has not seen.
struct TriedModel {
  Estimate estimate;
  std::vector<LeftOut> left_out;
};

/// The first stages of identify() with the model of the options, and the cross-validation: no diagnostics, which no
/// choice of a model looks at. Errors: identify()'s.
Expected<TriedModel> try_model(const Recording& recording, const Constraints& constraints,
                               const IdentifyOptions& options);

}  // namespace artcal
