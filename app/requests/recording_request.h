#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/requests/access_option.h"
#include "artefacts/constraints/bound_recording.h"

namespace artcal {

/// The recording that a command works on, and what may be read for it.
struct RecordingRequest {
  std::string path;
  RecordingOptions options;

  /// Adds the argument RECORDING; the options are added where their place in the help is.
  void add_path_to(CLI::App& parser);
  [[nodiscard]] FileAccess access() const { return options.of(path); }

  [[nodiscard]] Expected<Recording> read() const;
  /// bind_recording(), of scans the points that surely lie on a ball.
  [[nodiscard]] Expected<BoundRecording> bind(Recording recording) const;
  [[nodiscard]] Expected<BoundRecording> read_bound() const;
  /// Refuses outputs that would overwrite one another or a file that the recording refers to.
  [[nodiscard]] Expected<void> check_outputs(const std::vector<std::string>& outputs, const Recording& recording) const;
};

}  // namespace artcal
