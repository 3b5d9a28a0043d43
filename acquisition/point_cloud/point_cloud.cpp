#include "acquisition/point_cloud/point_cloud.h"

#include <utility>

#include "acquisition/coincidence/coincident_points.h"
#include "acquisition/point_cloud/cloud_formats.h"
#include "acquisition/point_cloud/cloud_limits.h"
#include "core/files/hash.h"
#include "core/files/size_limits.h"
#include "core/parallel.h"

namespace artcal {

Expected<ReadCloud> read_cloud(const std::filesystem::path& path, const CloudUnits& units, const TextColumns& columns) {
  return read_cloud(path, units, columns, {});
}

Expected<ReadCloud> read_cloud(const std::filesystem::path& path, const CloudUnits& units, const TextColumns& columns,
                               const CloudLimits& limits) {
  auto file = read_unhashed_file_bytes(path, largest::points, "a point file");
  if (!file) {
    return tl::unexpected(file.error());
  }
  std::string hash;
  Expected<ReadCloud> read;
  side_by_side([&] { hash = sha256(file->bytes); }, [&] { read = parse_cloud(*file, units, columns, limits); });
  file->bytes = std::string();  // before anything else takes memory
  if (read) {
    read->cloud.input.sha256 = std::move(hash);
    drop_coincident_points(read->cloud);
  }
  return read;
}

Expected<PointCloud> read_point_cloud(const std::filesystem::path& path, const CloudUnits& units) {
  return read_cloud(path, units).map([](ReadCloud&& read) { return std::move(read.cloud); });
}

}  // namespace artcal
