#pragma once

#include <filesystem>

#include "acquisition/recording.h"
#include "artefacts/artefact.h"
#include "core/error.h"

namespace artcal {

struct ArtefactFile {
  Artefact artefact;
  InputFile input;
};

/// Reads artefact.toml. Format: docs/files.md. Refused: two features of one name, a distance that names
/// an unknown feature, is there twice, has coordinates at one end only or contradicts those at both beyond
/// its U, an uncertainty of zero.
Expected<ArtefactFile> read_artefact_file(const std::filesystem::path& path);

}  // namespace artcal
