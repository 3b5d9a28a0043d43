#pragma once

#include <string>
#include <vector>

#include "identification/estimation.h"
#include "identification/evaluation/outliers.h"
#include "identification/uncertainty/estimate_uncertainty.h"

namespace artcal {

/// What the readings say of an estimate.
struct Diagnostics {
  Evaluation before;  ///< of the nominal arm; NaN where it cannot be evaluated
  Outliers outliers;
  std::vector<ArtefactInfluence> influences;
  ModelStudy residuals;               ///< whether they hold what the model lacks
  std::vector<std::string> warnings;  ///< of all this, in this order
};

/// `system` is make_system() at the arm of the estimate.
Diagnostics diagnose(const System& system, const Estimate& estimate, const EstimateUncertainty& uncertainty,
                     const Recording& recording, const IdentifyOptions& options);

}  // namespace artcal
