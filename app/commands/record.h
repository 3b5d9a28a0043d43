#pragma once

#include "app/commands/command.h"

namespace artcal {

Run set_up_record(CLI::App& parser);

}  // namespace artcal
