#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace artcal {

/// A result of any kind, as this version writes it.
struct ResultJson {
  nlohmann::ordered_json json;  ///< an object with a text `kind`
  std::string sha256;           ///< of the file
};

/// Reads a file that `--json` wrote, and brings an older one up to date (schema_version.h). Refused: what is no result,
/// a version of the schema that this program does not know.
Expected<ResultJson> read_result_json(const std::string& path);

}  // namespace artcal
