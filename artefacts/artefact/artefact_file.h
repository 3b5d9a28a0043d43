#pragma once

#include <filesystem>
#include <optional>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"
#include "core/error.h"
#include "core/files/file_access.h"

namespace artcal {

struct ArtefactFile {
  Artefact artefact;
  InputFile input;
  std::optional<InputFile> certificate;  ///< the digital certificate that it names
  std::string certificate_name;          ///< as the file has it; empty: it names none
};

/// Reads artefact.toml, and the digital certificate that it names. Format: docs/files.md. Refused: what a certificate
/// cannot say, and what contradicts itself (artefacts/artefact/consistency).
/// Refused: a reference to a file that `access` does not allow; without it, all are allowed.
Expected<ArtefactFile> read_artefact_file(const std::filesystem::path& path);
Expected<ArtefactFile> read_artefact_file(const std::filesystem::path& path, const FileAccess& access);

}  // namespace artcal
