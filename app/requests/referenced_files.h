#pragma once

#include <vector>

#include "acquisition/recording/recording.h"
#include "core/files/file_access.h"

namespace artcal {

/// Every file that a recording refers to, whether it has been read or not: readings, arm, artefacts and their
/// certificates, specification and scans. None of them may be overwritten by a result of this recording.
std::vector<InputFile> referenced_files(const Recording& recording, const FileAccess& access);

}  // namespace artcal
