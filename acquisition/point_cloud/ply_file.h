#pragma once

#include "acquisition/point_cloud/point_cloud.h"
#include "core/files/file_bytes.h"

namespace artcal {

/// The vertices of a PLY, as point_cloud.h has it.
Expected<PointCloud> parse_ply(const FileBytes& file, const CloudUnits& units);

}  // namespace artcal
