#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/arm.h"
#include "acquisition/arm/arm_identification.h"
#include "acquisition/recording/noise.h"
#include "acquisition/recording/reading.h"
#include "acquisition/recording/recorded_scan.h"
#include "core/files/input_file.h"

namespace artcal {

/// What a recording asks of its own identification; the command line may say more.
struct IdentifyRequest {
  bool asked = true;              ///< whether it is to be identified: it says so, or asks for nothing at all
  std::vector<std::string> hold;  ///< parameters to keep at their nominal value
  std::vector<std::string> free;  ///< parameters to identify although they are fixed by default
  std::string loss = "none";      ///< none, huber, cauchy
  std::string model = "dh";       ///< groups of parameters, as identification/models/model.h reads them
};

/// What a recording asks of its own verification.
struct VerifyRequest {
  std::string standard;  ///< iso10360-12, b89.4.22, sphere-plate; empty: it is not to be verified
};

/// One recording session: an arm and what it read. Joint angles in rad, as the encoders gave them.
struct Recording {
  std::string name;
  std::string date;                                     ///< of the measurement, "2026-03-10"; empty: not stated
  Arm arm;                                              ///< the nominal arm, the start of identification
  std::optional<ArmIdentification> arm_identification;  ///< what the arm's file says of how it was identified
  Eigen::MatrixXd joints;  ///< joint × reading, rad; NaN for readings of coordinates alone
  std::vector<Reading> readings;
  Labels artefacts, placements, features, orientations, repeats;
  std::vector<std::string> artefact_paths;  ///< artefact files named by the recording, resolved
  std::string specification_path;           ///< the specification named by the recording, resolved; or empty
  std::vector<RecordedScan> scans;          ///< not read yet: artefacts/scans/scan_readings.h makes readings of them
  Noise noise;
  IdentifyRequest identify;
  VerifyRequest verify;
  std::vector<std::string> files;                  ///< readings files, as Reading::file counts them
  std::vector<InputFile> inputs;                   ///< every file read so far, in order
  std::vector<std::string> warnings;               ///< things that look wrong but may be right
  std::optional<std::string> repeated_readings{};  ///< the one of them about readings that repeat another, if any

  /// "readings.csv:12", for messages about a reading.
  [[nodiscard]] std::string where(int reading) const;
};

}  // namespace artcal
