#pragma once

#include <limits>

namespace artcal {

/// How a limit and an uncertainty make a verdict. The guard band g is what a value must stay away from its
/// limit, on either side, for anything to be proven.
enum class DecisionRule {
  Iso14253_2017,  ///< g = 1.65·u: at most one in twenty wrong acceptances where the value is normal
  Iso14253_2013,  ///< g = U = 2·u
  Simple,         ///< g = 0: whoever signs bears the risk
};

/// The terms of ISO 14253-1.
enum class Verdict {
  ConformityProven,     ///< |E| ≤ MPE − g
  NonConformityProven,  ///< |E| > MPE + g
  NeitherProven,        ///< in between
  NotJudged,            ///< no limit is stated
};

/// g, mm, for a standard uncertainty u ≥ 0 of the test value. With few degrees of freedom Student's factor of the same
/// probability takes the place of 1.65 or 2 where it is larger (JCGM 100, G.3).
double guard_band(DecisionRule rule, double u, double degrees_of_freedom = std::numeric_limits<double>::infinity());

/// REQUIRES: limit ≥ 0, u ≥ 0. Where g > MPE nothing can conform: the test is too coarse for the limit.
Verdict decide(double value, double limit, double u, DecisionRule rule,
               double degrees_of_freedom = std::numeric_limits<double>::infinity());

/// "ISO 14253-1:2017, g = 1.65 u", for reports.
const char* text_of(DecisionRule rule);
const char* text_of(Verdict verdict);

}  // namespace artcal
