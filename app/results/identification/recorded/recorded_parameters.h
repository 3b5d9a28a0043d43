#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "app/results/recorded/recorded_object.h"
#include "identification/identify.h"

namespace artcal {

/// A parameter of the arm as a result has it (table "parameter" of docs/result-schema.md), in `unit`.
struct RecordedParameter {
  std::string name, unit;
  double nominal = 0.0, identified = 0.0;
  ParameterState state = ParameterState::Identified;
  double u = 0.0;                                                       ///< standard; 0 unless identified
  double degrees_of_freedom = std::numeric_limits<double>::infinity();  ///< effective, of u

  /// If only weakly.
  [[nodiscard]] bool is_identified() const;
};

/// The covariance matrix of the identified parameters (table "covariance"), in their order.
struct RecordedCovariance {
  std::vector<std::string> parameters;
  Eigen::MatrixXd matrix;
};

/// What the readings determine (table "coupling").
struct RecordedIdentifiability {
  struct Direction {
    std::string fixed, text;
    std::vector<std::pair<std::string, double>> motion;  ///< changes of parameters that no reading sees
  };
  std::size_t parameters = 0, rank = 0;
  double angle_scale = 0.0;  ///< mm
  std::vector<Direction> unidentifiable;
  std::vector<std::string> weak;  ///< in words
};

/// Each reads the part of an identification; all throw NotAsInSchema.
std::vector<RecordedParameter> recorded_parameters(const RecordedObject& identification);
RecordedCovariance recorded_covariance(const RecordedObject& identification);
RecordedIdentifiability recorded_identifiability(const RecordedObject& identification);

}  // namespace artcal
