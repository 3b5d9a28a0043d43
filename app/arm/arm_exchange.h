#pragma once

#include <string>
#include <vector>

#include "acquisition/arm/exchange/urdf_read.h"
#include "app/arm/rounding_options.h"
#include "app/commands/command.h"

namespace artcal {

/// `artcal arm import`: an arm file from a URDF or a Universal Robots kinematics file.
struct ArmImport {
  std::string input, output;
  ChainEnds ends;
  bool own_base = false, quiet = false;

  CLI::App* add_to(CLI::App& parser);
  [[nodiscard]] Expected<int> run() const;
};

/// `artcal arm export`: a URDF from an arm file.
struct ArmExport {
  std::string input, output;
  std::vector<double> tip_orientation;  ///< roll, pitch, yaw, rad
  RoundingOptions rounding;
  bool urdf = false, quiet = false;

  CLI::App* add_to(CLI::App& parser);
  [[nodiscard]] Expected<int> run() const;
};

}  // namespace artcal
