#pragma once

#include <optional>

namespace artcal {

/// The noise of one reading. Either `reading` is given, the standard deviation of a coordinate in mm
/// whatever the posture; or `encoder` (rad, a joint) and `probing` (mm, a coordinate), from which each
/// reading gets the noise of its own posture; or nothing, and the noise is estimated from the residuals.
struct Noise {
  std::optional<double> reading;
  std::optional<double> encoder;
  std::optional<double> probing;

  [[nodiscard]] bool is_given() const { return reading || encoder || probing; }
};

}  // namespace artcal
