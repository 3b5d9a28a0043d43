#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "acquisition/point_cloud/cloud_limits.h"
#include "core/files/file_access.h"

namespace artcal {

/// What a batch is asked beside the recordings.
struct BatchOptions {
  bool leave_out = false;                 ///< identify again without each placement
  bool anywhere = false;                  ///< recordings may refer to files anywhere
  CloudLimits limits = {};                ///< of the memory that compressed points of scans may take
  std::vector<std::string> folders = {};  ///< absolute; the recordings found in them may refer to all that is in them

  /// What results depend on, as the store states it.
  [[nodiscard]] std::string text() const { return leave_out ? "leave-out" : ""; }
  /// Which files this recording may refer to.
  [[nodiscard]] FileAccess access_of(const std::filesystem::path& recording) const;
};

}  // namespace artcal
