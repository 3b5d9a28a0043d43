#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "acquisition/point_cloud/point_cloud.h"
#include "tests/support/temporary_folder.h"

namespace artcal::testing {

/// Writes bytes to a file and reads them as a cloud.
class CloudFile : public ::testing::Test {
 protected:
  Expected<PointCloud> read(std::string_view name, std::string_view bytes, const CloudUnits& units = {}) {
    return read_point_cloud(folder_.write(name, bytes), units);
  }
  /// The refusal without the folder.
  std::string refusal(std::string_view name, std::string_view bytes, const CloudUnits& units = {}) {
    const auto cloud = read(name, bytes, units);
    return cloud ? "accepted" : cloud.error().text().substr(folder_.path().string().size() + 1);
  }
  TemporaryFolder folder_;
};

}  // namespace artcal::testing
