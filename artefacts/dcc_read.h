#pragma once

#include "artefacts/dcc.h"
#include "core/text_file.h"

namespace artcal {

/// Whether a file's text is XML rather than TOML.
bool looks_like_xml(const TextFile& file);

/// read_dcc_file() of a text that has been read.
Expected<DccCertificate> read_dcc(const TextFile& file);

}  // namespace artcal
