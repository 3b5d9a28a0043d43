#pragma once

#include "app/commands/command.h"

namespace artcal {

Run set_up_inspect(CLI::App& parser);

}  // namespace artcal
