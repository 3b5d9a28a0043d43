#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace artcal {

/// Writes a file whole or not at all: to a temporary file beside it, flushed to disk, then renamed.
Expected<void> write_file(const std::string& path, const std::string& text);

/// Writes JSON to a file, or to standard output for "-"; nothing for an empty path.
Expected<void> write_json(const std::string& path, const nlohmann::ordered_json& json);

/// Tells a person on standard error what went wrong; returns the exit code.
int report_error(const Error& error);

}  // namespace artcal
