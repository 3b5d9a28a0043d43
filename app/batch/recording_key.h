#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/batch/batch_options.h"
#include "core/error.h"
#include "core/files/input_file.h"

namespace artcal {

/// The paths of inputs as seen from the recording's folder, so that a result does not depend on where it lies.
std::vector<InputFile> seen_from(const std::filesystem::path& folder, const std::vector<InputFile>& inputs);

/// The name of a result: 32 hexadecimal digits of the SHA-256 over the program's version, the options, the recording's
/// name and the contents of all inputs in the order in which they were read. Not over their paths: a recording that was
/// moved or renamed is the same recording, and the paths in it are part of its content.
std::string recording_key(const std::vector<InputFile>& inputs, const std::string& name, const BatchOptions& options);

/// The text without the folder, where a path in it begins with the folder's.
std::string without_folder(std::string text, const std::filesystem::path& folder);

/// The same inputs with the hashes that the files have now; empty where one cannot be read.
std::vector<InputFile> hashed_now(const std::filesystem::path& folder, const std::vector<InputFile>& inputs);

/// The first input whose content is no longer what was read, or an empty path.
std::string first_changed(const std::filesystem::path& folder, const std::vector<InputFile>& inputs);

}  // namespace artcal
