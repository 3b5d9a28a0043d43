#pragma once

#include "acquisition/point_cloud/cloud_limits.h"
#include "acquisition/point_cloud/point_cloud.h"
#include "core/files/file_bytes.h"

namespace artcal {

/// The points of a PCD, as point_cloud.h has it. Refused: compressed points that would take more memory than allowed,
/// before they are decompressed.
Expected<PointCloud> parse_pcd(const FileBytes& file, const CloudUnits& units, const CloudLimits& limits = {});

}  // namespace artcal
