#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace artcal {

/// What an identification leaves in the arm's file beside the parameters.
struct ArmIdentification {
  std::string program;                  ///< "artcal 0.1.0"
  std::string recording;                ///< SHA-256 of the recording file it was identified from
  std::vector<std::string> parameters;  ///< names of the identified ones
  Eigen::MatrixXd covariance;           ///< of these, in their units
  std::optional<double> noise;          ///< standard deviation of a reading's coordinate, mm
  std::optional<double> encoder_noise;  ///< standard deviation of each joint, rad; where the noise was known by parts
  std::optional<double> probing_noise;  ///< and of the tip's coordinates beside that, mm
  std::vector<std::string> misfits;     ///< why the arm is no solution of its readings; empty: it is one
  /// Unmodelled error: factor that the covariance's standard uncertainties were enlarged by, to what placements left
  /// out showed; 1 where they showed none.
  double unmodelled = 1.0;
  /// Fingerprints of the readings it was identified from (reading_fingerprint.h), sorted; those of the readings behind
  /// the parameters that it started from are among them. None in files of earlier versions.
  std::vector<std::string> readings;
};

}  // namespace artcal
