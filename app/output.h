#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "acquisition/recording.h"
#include "core/error.h"

namespace artcal {

/// Writes a file whole or not at all: to a temporary file beside it, flushed to disk, then renamed. Pipes
/// and devices are written to as they are.
Expected<void> write_file(const std::string& path, const std::string& text);

/// Refuses outputs that would overwrite an input of the same result, or one another. Empty ones and "-" do
/// not count.
Expected<void> check_outputs(const std::vector<std::string>& outputs, const std::vector<InputFile>& inputs);

/// JSON as files hold it: pure ASCII, so that no terminal obeys a name in it.
std::string json_text(const nlohmann::ordered_json& json);

/// Writes JSON to a file, or to standard output for "-"; nothing for an empty path.
Expected<void> write_json(const std::string& path, const nlohmann::ordered_json& json);

/// Tells a person on standard error what went wrong; returns the exit code.
int report_error(const Error& error);

}  // namespace artcal
