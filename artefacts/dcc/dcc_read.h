#pragma once

#include <filesystem>

#include "artefacts/dcc/dcc.h"
#include "core/error.h"

namespace artcal {

struct TextFile;  // core/files/text_file.h

/// Whether a file's text is XML rather than TOML.
bool looks_like_xml(const TextFile& file);

/// Reads a DCC. Texts are passed over; a quantity that is not read (a number that is none, complex numbers) has a
/// fault and does not keep the others from being read. Refused: what is no DCC of these versions, a document type or
/// entities of its own, deep nesting, another encoding than UTF-8, a date that is none, more than 16 MiB.
Expected<DccCertificate> read_dcc_file(const std::filesystem::path& path);

/// The same of a text that has been read.
Expected<DccCertificate> read_dcc(const TextFile& file);

}  // namespace artcal
