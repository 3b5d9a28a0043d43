#pragma once

#include <string>
#include <vector>

#include "identification/evaluation/misfit.h"
#include "identification/initial/initial_alignment.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/problem/preparation.h"

namespace artcal {

/// What a converged fit from one initial alignment says of the arm.
struct Estimate {
  Alignment alignment = Alignment::None;
  int attempt = 1;  ///< initial alignments tried, of an estimate without misfits until it was found
  Preparation preparation;
  ArmFit fit;
  Evaluation after;                  ///< of the readings by the arm found
  std::vector<std::string> misfits;  ///< why it is no solution, see misfits(); empty: it is one
  std::vector<std::string> weak;     ///< parameters with a weak prior, because the readings hardly determine them
  std::vector<FixedMember> fixed;    ///< of the model's groups
};

/// Tries the initial alignments in their order until a fit is surely the solution: the nominal arm saw its features, or
/// the residuals are of the size of the stated noise, or another alignment led to the same minimum. Where none is, the
/// estimate whose residuals are smallest, with its misfits.
/// IdentifyOptions::start is tried before them and is enough where it leads to an estimate without misfits.
/// No solution: no alignment led to a fit that converges; the error is that of the first.
Expected<Estimate> search_solution(const Recording& recording, const Constraints& constraints,
                                   const IdentifyOptions& options);

/// search_solution(), with an answer for whoever asks why there is none. No solution: as there, or a fit with misfits
/// unless IdentifyOptions::accept_misfit; the message names readings and certified values that an arm found without
/// them contradicts, and axes that are too nearly parallel for the model.
Expected<Estimate> find_estimate(const Recording& recording, const Constraints& constraints,
                                 const IdentifyOptions& options);

}  // namespace artcal
