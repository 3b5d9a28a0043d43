#pragma once

#include <string_view>

#include "acquisition/point_cloud/cloud_limits.h"
#include "acquisition/point_cloud/read_cloud.h"
#include "core/files/file_bytes.h"

namespace artcal {

/// Any cloud from bytes that are in memory; `file.path` names them in messages and as the cloud's input.
Expected<PointCloud> parse_point_cloud(const FileBytes& file, const CloudUnits& units);
Expected<ReadCloud> parse_cloud(const FileBytes& file, const CloudUnits& units,
                                const TextColumns& columns = std::nullopt, const CloudLimits& limits = {});

/// The name of a format whose fields are known, PCD, PLY, PTX, OBJ or STL, by the bytes; empty for a table in text.
std::string_view cloud_format_name(std::string_view bytes);

}  // namespace artcal
