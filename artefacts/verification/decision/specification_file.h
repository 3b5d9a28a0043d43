#pragma once

#include <filesystem>

#include "acquisition/recording/recording.h"
#include "artefacts/verification/decision/specification.h"
#include "core/error.h"

namespace artcal {

struct SpecificationFile {
  Specification specification;
  InputFile input;
};

/// Reads specification.toml. Format: docs/files.md. Refused: a quantity that is not known or stated twice, a
/// limit of none of the three forms or not above zero, temperatures the wrong way round, counts that are none.
Expected<SpecificationFile> read_specification_file(const std::filesystem::path& path);

}  // namespace artcal
