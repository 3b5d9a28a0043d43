#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/history/arm_history.h"

namespace artcal {

/// A length, ball or seat as one verification found it: its repeats taken together.
struct ValueThen {
  std::size_t verification = 0;  ///< into ArmHistory::verifications
  int repeats = 0;
  double value = 0.0;            ///< mean, mm
  double u = 0.0;                ///< of the mean, mm: √(u²(test) + s²/repeats); with repeats s has u(points) in it
  double coverage_factor = 2.0;  ///< of U for 95 %, by the effective degrees of freedom of u
  std::optional<double> limit;
};

/// The same value in one verification after the other by the same standard, the oldest first.
struct ValueOverTime {
  std::string standard;
  Quantity quantity = Quantity::LengthUni;
  std::string artefact, placement, first, second;
  std::vector<ValueThen> points;
};

/// The value of a quantity that was worst (as worst_of() has it), in one verification after the other.
struct WorstOverTime {
  struct Point {
    std::size_t verification = 0;  ///< into ArmHistory::verifications
    const TestValue* value = nullptr;
  };
  std::string standard;
  Quantity quantity = Quantity::LengthUni;
  std::vector<Point> points;
};

/// Sorted by standard, quantity, artefact, placement and features. s is that of a single repeat, pooled over all values
/// of the quantity in a verification; 0 where nothing was repeated. Values that were set aside are left out.
std::vector<ValueOverTime> values_over_time(const ArmHistory& history);

/// Sorted by standard and quantity. Refers to `history`, which must stay.
std::vector<WorstOverTime> worst_over_time(const ArmHistory& history);

}  // namespace artcal
