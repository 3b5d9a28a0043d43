#pragma once

#include <CLI/CLI.hpp>

#include "acquisition/point_cloud/cloud_limits.h"

namespace artcal {

/// Adds --max-memory.
inline void add_max_memory(CLI::App& parser, CloudLimits& limits) {
  parser
      .add_option("--max-memory", limits.max_memory,
                  "memory that compressed points may take, such as 4GB; without it sixteen times the file, and 256 MiB "
                  "for a small one")
      ->transform(CLI::AsSizeValue(false))
      ->type_name("SIZE")
      ->default_str("");  // 0 stands for none
}

}  // namespace artcal
