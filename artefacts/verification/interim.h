#pragma once

#include <string>
#include <vector>

#include "artefacts/verification/verification.h"

namespace artcal {

/// The repeats of one length, ball or seat in one placement, then and now.
struct Drift {
  Quantity quantity = Quantity::LengthUni;
  std::string artefact, placement, first, second;
  int repeats_then = 0, repeats_now = 0;
  double then = 0.0, now = 0.0;  ///< means, mm
  double drift = 0.0;            ///< now − then, mm
  double u = 0.0;                ///< standard uncertainty of the drift, mm
  double repeatability = 0.0;    ///< s: of one value of this quantity, pooled over all repeats of both; mm
  int degrees_of_freedom = 0;    ///< of it; 0: there were no repeats, and nothing can be called significant
  /// Of u, which also holds what both budgets state (Welch, Satterthwaite); infinite where repeats add nothing to it.
  double effective_degrees_of_freedom = 0.0;
  double coverage = 0.0;     ///< significance_factor() of all drifts together, by these degrees of freedom
  bool significant = false;  ///< beyond `coverage` times u
};

/// A few values held against an earlier verification of the same arm.
struct InterimCheck {
  std::vector<Drift> drifts;
  std::vector<std::string> not_compared;  ///< values now that the earlier verification does not have

  [[nodiscard]] bool any_significant() const;
  [[nodiscard]] bool any_judged() const;  ///< whether repeats say of at least one drift if it is significant
};

/// Compares values of the same quantity, artefact, placement and features:
///     u² = u²(then) + u²(now) + s²·(1/n_then + 1/n_now).
/// s is pooled over both, unless an F test says that they scatter differently: then each has its own.
/// Where both rest on the same certified value, its u(cal) is in both alike and cancels.
InterimCheck compare(const std::vector<TestValue>& now, const std::vector<TestValue>& then);

}  // namespace artcal
