#pragma once

#include <optional>
#include <string>

namespace artcal {

/// A maximum permissible error as a data sheet states it, in one of three forms:
///     B,   A + L/K,   min(A + L/K, B).
/// In artcal everything is mm: `slope` is 1/K once K's unit is taken in (A = 20 um with L/50, L in mm and
/// the result in um, is base 0.020 and slope 0.001/50).
struct Limit {
  double base = 0.0;                ///< A, or B where it stands alone; mm
  double slope = 0.0;               ///< mm per mm
  std::optional<double> most = {};  ///< B of the third form, mm

  /// The limit for a length, mm.
  [[nodiscard]] double at(double length) const;
};

}  // namespace artcal
