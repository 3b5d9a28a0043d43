#pragma once

#include <string>

#include "app/arm/rounding_options.h"

namespace artcal {

/// `artcal arm round`: an arm with rounded numbers, and by how much its tips move.
struct RoundRequest {
  std::string input, output;
  RoundingOptions rounding;
  bool quiet = false;

  CLI::App* add_to(CLI::App& parser);
  [[nodiscard]] Expected<int> run() const;
};

}  // namespace artcal
