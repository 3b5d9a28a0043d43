#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/results/evaluation/recorded_evaluation.h"
#include "app/results/recorded/recorded_head.h"
#include "app/results/verification/recorded_plate.h"
#include "app/results/verification/recorded_value.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// A verification as its result has it (table "verification" of docs/result-schema.md).
struct RecordedVerification {
  RecordedCircumstances circumstances;
  std::string standard, specification, decision_rule;  ///< no limits are stated where `specification` is empty
  bool is_of_reported_coordinates = false;             ///< else they were computed from joint angles
  Conclusion conclusion = Conclusion::ConformityNotShown;
  std::vector<std::string> missing, waived;
  std::vector<RecordedValue> values;
  std::optional<std::vector<Drift>> drifts;  ///< of an interim check
  std::vector<RecordedPlate> plates;
  std::vector<RecordedCalibration> calibrations;
  std::vector<Articulation> articulations;
  std::optional<VolumetricSummary> volumetric;
  std::vector<RecordedFeature> features;  ///< none in results of earlier versions
  std::vector<Eigen::Vector3d> arm_path;  ///< from the base to the tip, mm; empty without joint angles
};

/// Throws NotAsInSchema.
RecordedVerification recorded_verification(const RecordedObject& result);

}  // namespace artcal
