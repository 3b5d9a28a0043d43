#pragma once

#include <string>

#include "app/shell/command_description.h"

namespace artcal {

/// Scripts that complete the program's commands, options, the values of options, and files of the kind that each
/// argument takes, for the three shells.
std::string bash_completion(const CommandDescription& program);
std::string zsh_completion(const CommandDescription& program);
std::string fish_completion(const CommandDescription& program);

}  // namespace artcal
