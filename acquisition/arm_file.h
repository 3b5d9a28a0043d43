#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm.h"
#include "acquisition/recording.h"
#include "core/error.h"

namespace artcal {

/// What an identification leaves in the arm's file beside the parameters.
struct ArmIdentification {
  std::string program;                  ///< "artcal 0.1.0"
  std::string recording;                ///< SHA-256 of the recording file it was identified from
  std::vector<std::string> parameters;  ///< names of the identified ones
  Eigen::MatrixXd covariance;           ///< of these, in their units
  std::optional<double> noise;          ///< standard deviation of a reading's coordinate, mm
  std::vector<std::string> misfits;     ///< why the arm is no solution of its readings; empty: it is one
};

/// An arm with what is known of it. Format: docs/files.md, "arm.toml".
struct ArmFile {
  Arm arm;
  std::optional<ArmIdentification> identification;
  InputFile input;
};

Expected<ArmFile> read_arm_file(const std::filesystem::path& path);

/// The file's text: in mm, rad and what goes with them, with every digit, so that reading it back gives the same bits.
std::string arm_file_text(const Arm& arm, const std::optional<ArmIdentification>& identification);

}  // namespace artcal
