#pragma once

#include <filesystem>
#include <optional>

#include "acquisition/recording.h"
#include "artefacts/artefact.h"
#include "core/error.h"

namespace artcal {

struct ArtefactFile {
  Artefact artefact;
  InputFile input;
  std::optional<InputFile> certificate;  ///< the digital certificate that it names
};

/// Reads artefact.toml, and the digital certificate that it names. Format: docs/files.md. Refused: what a certificate
/// cannot say, and what contradicts itself (artefacts/consistency).
Expected<ArtefactFile> read_artefact_file(const std::filesystem::path& path);

}  // namespace artcal
