#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "acquisition/point_cloud/cloud_limits.h"
#include "artefacts/scans/scan_readings.h"
#include "core/files/file_access.h"

namespace artcal {

/// --allow-outside: whether the files that a user names may refer to files anywhere.
struct AccessOption {
  bool anywhere = false;

  void add_to(CLI::App& parser);
  /// For a file that the user has named.
  [[nodiscard]] FileAccess of(const std::string& path) const {
    return anywhere ? FileAccess::anywhere() : FileAccess::beside(path);
  }
};

/// The same and --max-memory: for recordings, whose scans may be compressed.
struct RecordingOptions : AccessOption {
  CloudLimits limits;

  void add_to(CLI::App& parser);
  /// Of scans, for an identification.
  [[nodiscard]] ScanSelection scans() const { return {ScanUse::SureOfBall, nullptr, limits.max_memory}; }
};

}  // namespace artcal
