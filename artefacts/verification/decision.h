#pragma once

namespace artcal {

/// How a limit and an uncertainty make a verdict. The guard band g is what a value must stay away from its
/// limit, on either side, for anything to be proven.
enum class DecisionRule {
  Iso14253_2017,  ///< g = 1.65·u: at most one in twenty wrong acceptances where the value is normal
  Iso14253_2013,  ///< g = U = 2·u
  Simple,         ///< g = 0: whoever signs bears the risk
};

enum class Verdict {
  Conforms,        ///< |E| ≤ MPE − g
  DoesNotConform,  ///< |E| > MPE + g
  NothingProven,   ///< in between
  NotJudged,       ///< no limit is stated
};

/// g, mm, for a standard uncertainty u ≥ 0 of the test value.
double guard_band(DecisionRule rule, double u);

/// REQUIRES: limit ≥ 0, u ≥ 0. Where g > MPE nothing can conform: the test is too coarse for the limit.
Verdict decide(double value, double limit, double u, DecisionRule rule);

/// "ISO 14253-1:2017, g = 1.65 u", for reports.
const char* text_of(DecisionRule rule);
const char* text_of(Verdict verdict);

}  // namespace artcal
