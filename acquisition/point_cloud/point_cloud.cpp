#include "acquisition/point_cloud/point_cloud.h"

#include <utility>

#include "acquisition/coincidence/coincident_points.h"
#include "acquisition/point_cloud/cloud_formats.h"
#include "acquisition/point_cloud/cloud_limits.h"
#include "core/files/size_limits.h"

namespace artcal {

Expected<ReadCloud> read_cloud(const std::filesystem::path& path, const CloudUnits& units, const TextColumns& columns) {
  return read_cloud(path, units, columns, {});
}

Expected<ReadCloud> read_cloud(const std::filesystem::path& path, const CloudUnits& units, const TextColumns& columns,
                               const CloudLimits& limits) {
  return read_file_bytes(path, largest::points, "a point file").and_then([&](const FileBytes& file) {
    return parse_cloud(file, units, columns, limits).map([](ReadCloud read) {
      drop_coincident_points(read.cloud);
      return read;
    });
  });
}

Expected<PointCloud> read_point_cloud(const std::filesystem::path& path, const CloudUnits& units) {
  return read_cloud(path, units).map([](ReadCloud&& read) { return std::move(read.cloud); });
}

}  // namespace artcal
