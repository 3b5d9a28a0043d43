#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "app/results/recorded/recorded_object.h"

namespace artcal {

/// Deviations of readings as a result has them (table "deviation" of docs/result-schema.md), mm; NaN where an arm could
/// not be evaluated.
struct RecordedDeviation {
  std::string artefact, placement;
  std::size_t readings = 0;
  double rms = std::numeric_limits<double>::quiet_NaN();
  double maximum = std::numeric_limits<double>::quiet_NaN();
};

/// A certified length as an arm measures it (table "length"), mm and °C.
struct RecordedLength {
  std::string artefact, placement, first, second;
  double at_temperature = 0.0;                              ///< certified, at the temperature of the placement
  std::optional<double> certified;                          ///< by the certificate; not in results of earlier versions
  std::optional<double> certified_at;                       ///< the temperature that this is stated at
  double error = std::numeric_limits<double>::quiet_NaN();  ///< measured less certified; NaN as above
};

/// The readings of a recording judged by one arm (table "evaluation").
struct RecordedEvaluation {
  RecordedDeviation overall;
  std::size_t artefacts = 0;
  std::vector<RecordedDeviation> placements;
  std::vector<RecordedLength> lengths;
};

/// A placement judged by an arm that was identified without it (table "left_out").
struct RecordedLeftOut {
  RecordedDeviation deviation;
  std::vector<RecordedLength> lengths;
  bool is_refused = false;
};

/// Where a feature of a placement is, mm in the base frame: in "features" of an evaluation and of a verification.
struct RecordedFeature {
  std::string artefact, placement, feature;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
};

/// A reading that deviates by more than chance allows (table "outlier").
struct RecordedOutlier {
  std::string where, placement, feature;
  double deviation = 0.0;  ///< mm
  bool is_signed = true;
  double standardised = 0.0, limit = 0.0;
};

/// Each throws NotAsInSchema.
RecordedEvaluation recorded_evaluation(const RecordedObject& evaluation);
std::vector<RecordedFeature> recorded_features(const RecordedObject& evaluation_or_verification);
std::vector<RecordedLeftOut> recorded_left_out(const RecordedObject& identification);
std::vector<RecordedOutlier> recorded_outliers(const RecordedObject& identification);

}  // namespace artcal
