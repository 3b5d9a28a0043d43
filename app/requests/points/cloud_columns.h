#pragma once

#include <vector>

#include <CLI/CLI.hpp>

#include "acquisition/point_cloud/read_cloud.h"

namespace artcal {

/// Adds --columns to a command that reads points.
void add_columns_option(CLI::App& parser, std::vector<int>& columns);

/// What it was given; nothing where it was not. Usage errors for other than three different
/// columns from 1.
Expected<TextColumns> cloud_columns(const std::vector<int>& columns);

}  // namespace artcal
