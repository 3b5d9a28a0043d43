#pragma once

#include <vector>

#include "identification/estimation.h"
#include "identification/uncertainty/estimate_uncertainty.h"

namespace artcal {

/// Every parameter of the arm with its state, its value, its standard uncertainty and the effective degrees of freedom
/// of that.
std::vector<IdentifiedParameter> describe_parameters(const Arm& nominal, const Estimate& estimate,
                                                     const EstimateUncertainty& uncertainty, const Noise& noise);

/// What an estimate says of the numbers of the artefacts themselves.
std::vector<ArtefactValue> describe_artefacts(const Constraints& constraints, const Estimate& estimate,
                                              const EstimateUncertainty& uncertainty);

}  // namespace artcal
