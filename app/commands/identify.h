#pragma once

#include <string>

#include "app/commands/command.h"

namespace artcal {

/// Does what `artcal identify RECORDING -o ARM --json FILE` does: the same bytes. Empty names: not written.
Expected<int> identify_recording(const std::string& recording, const std::string& arm, const std::string& json,
                                 bool quiet);

}  // namespace artcal
