#pragma once

#include <vector>

#include "app/commands/command.h"

namespace artcal {

/// All commands, in the order in which help lists them. Help, manual pages and completion follow from it.
const std::vector<Command>& command_table();

}  // namespace artcal
