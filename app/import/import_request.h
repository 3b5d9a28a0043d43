#pragma once

#include <string>

#include "acquisition/import/imported_readings.h"
#include "app/commands/command.h"

namespace artcal {

/// `artcal import`: readings of another program's file as readings.csv and, with an artefact, as a recording.
struct ImportRequest {
  std::string input, folder, columns, separator, format = "auto", unit, joint_unit;
  std::string artefact, arm, probe_radius;
  int skip = 0;
  bool points_are_measured = false;
  bool quiet = false;

  void add_to(CLI::App& parser);
  [[nodiscard]] Expected<int> run() const;
};

}  // namespace artcal
