#pragma once

#include <filesystem>

#include "acquisition/recording/recording.h"
#include "core/error.h"
#include "core/files/file_access.h"

namespace artcal {

/// Reads recording.toml, the arm it names and its readings. Paths in the file are taken from the file's
/// own folder. Format: docs/files.md, "recording.toml". Scans are not read here: what the recording says of them
/// stands in Recording::scans, and who has the artefacts makes readings of them. Nor are artefact files: their paths
/// stand in Recording::artefact_paths, and whether a reading's labels name something real is known to
/// artefacts/constraint.
/// Refused: a reference to a file that `access` does not allow; without it, all are allowed.
Expected<Recording> read_recording(const std::filesystem::path& path);
Expected<Recording> read_recording(const std::filesystem::path& path, const FileAccess& access);

}  // namespace artcal
