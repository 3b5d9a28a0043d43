#pragma once

#include <string>
#include <vector>

#include "acquisition/recording/recording.h"

namespace artcal {

/// A recording's readings as readings.csv: angles in deg with 12 decimals (2e-14 rad), lengths in mm with 9,
/// temperatures with 4. Columns that would hold nothing are left out; so is the probe where there is one.
std::string readings_file_text(const Recording& recording);

/// Names of the files beside a recording.toml.
struct RecordingFiles {
  std::string arm;
  std::vector<std::string> artefacts;
  std::string readings;
};

/// A recording.toml that names these files, with the recording's noise and its scans, whose paths are written as they
/// are, without tolerance, places or thinning; no readings file where there are no readings. `comment` (lines without
/// #) comes first. The units are those of readings_file_text().
std::string recording_file_text(const Recording& recording, const RecordingFiles& files,
                                const std::vector<std::string>& comment);

}  // namespace artcal
