#pragma once

#include <filesystem>

#include "acquisition/recording/recorded_scan.h"
#include "core/files/file_access.h"
#include "core/toml/toml_document.h"

namespace artcal {

/// One [[scan]] of recording.toml; `units` are those of the recording, where the scan states none of its own. What is
/// wrong is noted in the table's document. Format: docs/files.md, "recording.toml".
RecordedScan read_scan_table(TomlTable table, const std::filesystem::path& folder, const FileAccess& access,
                             const CloudUnits& units);

}  // namespace artcal
