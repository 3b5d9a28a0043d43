#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/stream/row_file.h"
#include "core/error.h"
#include "core/files/file_access.h"

namespace artcal {

/// What a recording is begun with.
struct RecordingBegin {
  std::filesystem::path folder, arm;
  std::vector<std::filesystem::path> artefacts;
  std::string date;  ///< of the measurement, "2026-03-10"
};

/// Begins a recording in a folder, or opens it where it was begun: readings.csv with this header, recording.toml, and
/// copies of the files of arm, artefacts and their certificates, so that the folder holds all that its result rests on.
/// Refused: a recording that was begun with other files or columns, or by another command.
Expected<RowFile> begin_recording(const RecordingBegin& begin, const FileAccess& access, const std::string& header);

}  // namespace artcal
