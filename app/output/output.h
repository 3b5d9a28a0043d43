#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "acquisition/recording/recording.h"
#include "core/error.h"

namespace artcal {

/// Writes a file whole or not at all: to a temporary file beside it, flushed to disk, then renamed. Pipes
/// and devices are written to as they are.
Expected<void> write_file(const std::string& path, const std::string& text);

/// Refuses outputs that would overwrite an input of the same result, or one another. Empty ones and "-" do
/// not count.
Expected<void> check_outputs(const std::vector<std::string>& outputs, const std::vector<InputFile>& inputs);

/// What a file of results begins with.
enum class OutputKind { JsonFile, Page };

/// Refuses an output that would replace a file of another kind: for a command that cannot know all files that its
/// inputs refer to before it writes. No input is JSON or a page. A file that is empty or not there, "-" and devices
/// pass.
Expected<void> check_replaced(const std::string& output, OutputKind kind);

/// JSON as files hold it: pure ASCII, so that no terminal obeys a name in it.
std::string json_text(const nlohmann::ordered_json& json);

/// Writes JSON to a file, or to standard output for "-"; nothing for an empty path.
Expected<void> write_json(const std::string& path, const nlohmann::ordered_json& json);

/// Tells a person on standard error what went wrong; returns the exit code.
int report_error(const Error& error);

}  // namespace artcal
