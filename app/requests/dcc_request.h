#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "acquisition/recording/recording.h"
#include "artefacts/dcc/writing/dcc_document.h"

namespace artcal {

/// The options of a command that writes its result as a digital certificate.
struct DccRequest {
  std::string out, data;

  void add_to(CLI::App& parser);  ///< --dcc, --dcc-data
};

/// What only the laboratory knows; nothing where no certificate is asked for. Its file is noted as an input of the
/// recording. Refused: one of the two options without the other; a file that misses something; a certificate for
/// other days than the recording's.
Expected<std::optional<DccData>> read_certificate_data(const DccRequest& request, Recording& recording);

}  // namespace artcal
