#include "artefacts/verification/decision/decision.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/statistics.h"

namespace artcal {

double guard_band(DecisionRule rule, double u, double degrees_of_freedom) {
  switch (rule) {
    case DecisionRule::Iso14253_2017: return std::max(1.65, student_coverage_factor(0.90, degrees_of_freedom)) * u;
    case DecisionRule::Iso14253_2013: return std::max(2.0, student_coverage_factor(0.9545, degrees_of_freedom)) * u;
    case DecisionRule::Simple: break;
  }
  return 0.0;
}

Verdict decide(double value, double limit, double u, DecisionRule rule, double degrees_of_freedom) {
  assert(limit >= 0.0 && u >= 0.0);
  const double guard = guard_band(rule, u, degrees_of_freedom);
  const double size = std::abs(value);
  return size <= limit - guard  ? Verdict::ConformityProven
         : size > limit + guard ? Verdict::NonConformityProven
                                : Verdict::NeitherProven;
}

const char* text_of(DecisionRule rule) {
  switch (rule) {
    case DecisionRule::Iso14253_2017: return "ISO 14253-1:2017, guard band 1.65 u";
    case DecisionRule::Iso14253_2013: return "ISO 14253-1:2013, guard band U (k = 2)";
    case DecisionRule::Simple: break;
  }
  return "simple acceptance, no guard band";
}

const char* text_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::ConformityProven: return "conformity proven";
    case Verdict::NonConformityProven: return "non-conformity proven";
    case Verdict::NeitherProven: return "neither proven";
    case Verdict::NotJudged: break;
  }
  return "not judged";
}

}  // namespace artcal
