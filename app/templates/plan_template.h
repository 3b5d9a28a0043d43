#pragma once

#include <string>
#include <vector>

#include "app/templates/choice.h"

namespace artcal {

/// What `artcal new plan` writes: what `artcal simulate` makes a recording from.
struct PlanTemplate {
  std::string name = "my plan", arm = "arm.toml", artefact = "artefact.toml";
  std::string placements = "6", points = "25", encoder_noise = "2 arcsec", probing_noise = "3 um";

  [[nodiscard]] std::vector<Choice> choices();
  /// `folder`: where the file will be; the paths in it are from there. Reads the artefact where it is there: the faces
  /// of a gauge block get places. REQUIRES: check_choices().
  [[nodiscard]] std::string text(const std::string& folder) const;
};

}  // namespace artcal
