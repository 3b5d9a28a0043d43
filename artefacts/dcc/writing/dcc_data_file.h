#pragma once

#include <filesystem>

#include "artefacts/dcc/writing/dcc_document.h"
#include "core/error.h"
#include "core/files/input_file.h"

namespace artcal {

/// Reads what only the laboratory knows from a TOML file (docs/files.md, "dcc-data.toml"). Nothing has a default: what
/// is missing is refused.
struct DccDataFile {
  DccData data;
  InputFile input;
};
Expected<DccDataFile> read_dcc_data(const std::filesystem::path& path);

}  // namespace artcal
