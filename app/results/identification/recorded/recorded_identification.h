#pragma once

#include <optional>
#include <vector>

#include "app/results/evaluation/recorded_evaluation.h"
#include "app/results/evaluation/recorded_readings.h"
#include "app/results/identification/recorded/recorded_noise.h"
#include "app/results/identification/recorded/recorded_parameters.h"
#include "app/results/recorded/recorded_head.h"

namespace artcal {

/// An identification as its result has it (table "identification" of docs/result-schema.md).
struct RecordedIdentification {
  RecordedCircumstances circumstances;
  bool left_out_chose_the_model = false;  ///< new readings may deviate by more than placements left out
  std::vector<RecordedParameter> parameters;
  RecordedCovariance covariance;
  RecordedIdentifiability identifiability;
  RecordedNoise noise;
  std::optional<RecordedCrossValidation> cross_validation;
  RecordedEvaluation before, after;       ///< of the same placements and lengths
  std::vector<RecordedFeature> features;  ///< of `after`
  std::vector<RecordedLeftOut> left_out;
  std::vector<RecordedOutlier> outliers;
  std::vector<Eigen::Vector3d> arm_path;  ///< from the base to the tip, mm; empty without joint angles
  std::optional<RecordedReadings> readings;
};

/// Throws NotAsInSchema, also where parts are not of one another: a covariance of other parameters than the identified
/// ones, evaluations of other placements.
RecordedIdentification recorded_identification(const RecordedObject& result);

}  // namespace artcal
