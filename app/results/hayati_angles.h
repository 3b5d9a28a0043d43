#pragma once

#include <string>
#include <vector>

#include "acquisition/recording/recording.h"
#include "identification/identify.h"

namespace artcal {

/// Hayati's angle of a joint whose link joins nearly parallel axes, and the offset that it replaces as a parameter.
struct HayatiAngle {
  std::string angle;   ///< beta2
  std::string offset;  ///< d2
  int joint = 0;
};

/// Those that were identified.
std::vector<HayatiAngle> hayati_angles(const Identification& result);

/// A line that says which angles stand in place of which offsets, and why, and one for each offset of the arm's file
/// that is far beyond the arm and was replaced by zero. Empty without such angles.
std::string hayati_angles_text(const Recording& recording, const Identification& result);

}  // namespace artcal
