#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>

#include "acquisition/point_cloud/cloud_formats.h"
#include "tests/support/temporary_folder.h"

namespace artcal::fuzzing {

/// What must hold whatever the input; libFuzzer keeps the input where it does not.
inline void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

inline std::string_view bytes_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A refusal says something, in one line, and not at length.
inline void require_sentence(const Error& error) {
  require(!error.message.empty() && error.text().size() < 2000);
  require(error.text().find('\n') == std::string::npos);
}

/// The folder in which one target's inputs become files, where a reader takes no bytes.
inline const testing::TemporaryFolder& folder() {
  static const testing::TemporaryFolder one;
  return one;
}

/// What becomes of a record that repeats one before it: meshes give the vertices that facets share once each.
enum class Repeated { Kept, Merged };

/// Reads the bytes as a cloud and looks at what came out.
inline void read_cloud(const std::uint8_t* data, std::size_t size,
                       Expected<PointCloud> (*parse)(const FileBytes&, const CloudUnits&),
                       Repeated repeated = Repeated::Kept) {
  const FileBytes file{"input", std::string(bytes_of(data, size)), "hash"};
  for (const CloudUnits& units : {CloudUnits{1.0, {}}, CloudUnits{1e3, 1.0}}) {
    const auto cloud = parse(file, units);
    if (!cloud) {
      require_sentence(cloud.error());
      continue;
    }
    const auto points = static_cast<std::size_t>(cloud->points.cols());
    require(points > 0 && cloud->rows.size() == points && cloud->points.allFinite() && cloud->joints.allFinite());
    require(cloud->joints.size() == 0 || static_cast<std::size_t>(cloud->joints.cols()) == points);
    require(points + cloud->dropped <= size);
    require(cloud->rows.front() >= 0 && std::is_sorted(cloud->rows.begin(), cloud->rows.end(), std::less_equal<>{}));
    const std::size_t records = repeated == Repeated::Merged ? size : points + cloud->dropped;
    require(static_cast<std::size_t>(cloud->rows.back()) < records);
  }
}

}  // namespace artcal::fuzzing
