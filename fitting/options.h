#pragma once

#include <string_view>

#include "fitting/fit.h"

namespace artcal::fitting {

/// What a feature can be asked for.
struct Abilities {
  std::string_view feature;
  bool minimum_zone = false;
  bool enclosing = false;  ///< minimum circumscribed and maximum inscribed
  bool fixed_radius = false;
  bool tip = true;
  bool tip_needs_towards = false;
};

/// Usage errors for options that the feature does not have or that contradict each other.
Expected<void> check_options(const FitOptions& options, const Abilities& abilities);

}  // namespace artcal::fitting
