#pragma once

#include <vector>

#include "identification/least_squares/linearisation.h"
#include "identification/problem/loss.h"
#include "identification/uncertainty/covariance.h"

namespace artcal {

/// How much of each observation counts in a fit: ρ' of the loss, from 1 (all of it) to 0 (let go of).
struct LossWeights {
  std::vector<std::vector<double>> readings;  ///< by feature
  std::vector<double> distances;              ///< as Constraints::distances; 1 where one does not bind
  std::vector<double> shared;                 ///< as Constraints::shared
};
LossWeights loss_weights(const Constraints& constraints, const Weights& weights, Loss loss,
                         const WhitenedResiduals& residuals);

/// The same weights with those of a loss multiplied in.
Weights multiplied(Weights weights, const LossWeights& by);

/// What a fit leaves of one observation to check it by (Baarda 1968: redundancy number). Where all are right its
/// weighted residual has the covariance V, its diagonal block of (1 − H)(1 − H)ᵀ with H = A C AᵀW, A being the weighted
/// rows of all observations before the loss, W the loss weights and C = (AᵀWA)⁻¹: 1 − h of an observation that counts
/// in full, about 1 + h of one that alone was let go of.
struct Check {
  double variance = 1.0;  ///< mean of the diagonal of V; near 0 where the fit adapts to the observation
  double freedom = 1.0;   ///< degrees of freedom of the χ² that |r|² follows (Satterthwaite 1946): (tr V)²/tr V²
  double leverage = 0.0;  ///< mean of the diagonal of A C Aᵀ
  double influence =
      0.0;  ///< w times the part of tr A C Aᵀ that is of the arm's parameters; all add up to their number
};
struct Redundancy {
  std::vector<std::vector<Check>> readings;  ///< by feature
  std::vector<Check> distances, shared;      ///< as Constraints::distances and shared
};

/// `linearisation` is that at this arm with these loss weights. Where its factor is singular every Check is {1, its
/// dimension, 0, 0}.
Redundancy redundancy_of(const System& system, const Weights& weights, const LossWeights& counted,
                         const Linearisation& linearisation, const Arm& arm, const Unknowns& unknowns);

}  // namespace artcal
