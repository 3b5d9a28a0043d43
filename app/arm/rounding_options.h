#pragma once

#include <optional>
#include <string>

#include "acquisition/arm/arm.h"
#include "app/commands/command.h"

namespace artcal {

/// An arm as a controller or another program keeps it, and what is said of the rounding.
struct RoundedArm {
  Arm arm;
  std::string said;  ///< by how much tips and lengths change; empty where nothing was rounded
};

/// --digits and --steps, of the commands that write an arm.
struct RoundingOptions {
  int digits = -1;
  std::string steps;

  void add_to(CLI::App& parser);
  [[nodiscard]] bool are_given() const { return digits >= 0 || !steps.empty(); }
  /// Usage: both, or steps that cannot be read.
  [[nodiscard]] Expected<void> check() const;
  /// The arm unchanged where neither is given. Usage as check().
  [[nodiscard]] Expected<RoundedArm> rounded_arm(const Arm& arm) const;
};

}  // namespace artcal
