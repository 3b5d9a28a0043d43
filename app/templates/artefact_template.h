#pragma once

#include <string>
#include <vector>

#include "app/templates/choice.h"

namespace artcal {

/// What `artcal new artefact` writes: an artefact of a type with made-up certified values, to be replaced.
struct ArtefactTemplate {
  std::string name = "my artefact", type = "ball-bar", features = "default", length_unit = "mm";

  [[nodiscard]] std::vector<Choice> choices();
  /// Usage: a number of features that the type does not have. REQUIRES: check_choices().
  [[nodiscard]] Expected<std::string> text() const;
};

}  // namespace artcal
