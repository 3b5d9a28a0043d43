#pragma once

#include <string>

#include "core/error.h"

namespace CLI {
class App;
}

namespace artcal {

/// Remembers for this thread which values of the parsed command line name files, and by which option.
void note_command_line_paths(const CLI::App& program);

/// The error's line. Of a file that is not there, it says so where the command line named it, and by which option: else
/// a person looks for the name in the files that the command reads.
std::string text_with_origin(const Error& error);

}  // namespace artcal
