#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "artefacts/simulation/stand.h"
#include "core/error.h"

namespace artcal {

/// What a command line says of the stand that holds the artefacts: --floor, --lowest, --highest, --table.
struct StandOptions {
  std::string floor, lowest, highest;
  std::vector<std::string> tables;

  void add_to(CLI::App& parser);
  /// In place of the heights that `stand` has, and beside its tables. Refused: what is no length with its unit, a table
  /// that is not "X1,X2,Y1,Y2,TOP" in mm, limits without room between them.
  Expected<void> add_to(Stand& stand) const;
};

}  // namespace artcal
