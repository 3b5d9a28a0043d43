#pragma once

#include <cstddef>
#include <filesystem>

#include "acquisition/point_cloud/point_cloud.h"
#include "acquisition/point_cloud/read_cloud.h"

namespace artcal {

/// How much memory the points of a file may take while they are read. Points take at most some ten times their file;
/// only compressed ones can take more.
struct CloudLimits {
  /// Bytes; 0: sixteen times the file, and 256 MiB for a small one.
  std::size_t max_memory = 0;

  [[nodiscard]] std::size_t allowed(std::size_t file_size) const;
};

/// read_cloud() with other limits than those. Refused beside what it refuses: compressed points that would take more
/// memory, before they are decompressed.
Expected<ReadCloud> read_cloud(const std::filesystem::path& path, const CloudUnits& units, const TextColumns& columns,
                               const CloudLimits& limits);

}  // namespace artcal
