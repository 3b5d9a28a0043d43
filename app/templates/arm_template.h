#pragma once

#include <string>
#include <vector>

#include "app/templates/choice.h"

namespace artcal {

/// What `artcal new arm` writes: the numbers are those of a published arm, to be replaced.
struct ArmTemplate {
  std::string name = "my arm", joints = "6", convention = "standard";
  std::string length_unit = "mm", angle_unit = "deg", tip_radius = "3 mm";

  [[nodiscard]] std::vector<Choice> choices();
  /// REQUIRES: check_choices().
  [[nodiscard]] std::string text() const;
};

}  // namespace artcal
