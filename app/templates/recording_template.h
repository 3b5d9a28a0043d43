#pragma once

#include <string>
#include <vector>

#include "app/templates/choice.h"

namespace artcal {

/// What `artcal new recording` writes: a recording that names an arm, an artefact and a table of readings.
struct RecordingTemplate {
  std::string name = "my recording", readings_are = "joint-angles", arm = "arm.toml", artefact = "artefact.toml";
  std::string readings = "readings.csv", joint_unit = "deg", length_unit = "mm", tip_radius = "3 mm";
  std::string encoder_noise = "none", probing_noise = "none", standard = "none";

  [[nodiscard]] std::vector<Choice> choices();
  /// `folder`: where the file will be; the paths in it are from there. Usage: an encoder's noise for coordinates, or
  /// one of the two noises without the other. REQUIRES: check_choices().
  [[nodiscard]] Expected<std::string> text(const std::string& folder) const;
  /// The files that it names, as they were answered.
  [[nodiscard]] std::vector<std::string> named_files() const;

 private:
  [[nodiscard]] bool has_joints() const { return readings_are == "joint-angles"; }
};

}  // namespace artcal
