#include "app/results/verification/recorded_verification.h"

#include "app/results/result_names.h"

namespace artcal {

RecordedVerification recorded_verification(const RecordedObject& result) {
  RecordedVerification read;
  read.circumstances = recorded_circumstances(result);
  read.standard = result.text("standard");
  read.specification = result.text_or("specification");
  read.decision_rule = result.text("decision_rule");
  read.is_of_reported_coordinates = result.text("tip_centres") == "reported";
  read.conclusion = conclusion_named(result.text("conclusion"));
  read.missing = result.texts("missing");
  if (result.has("waived")) {  // results of earlier versions do not have it
    read.waived = result.texts("waived");
  }
  read.values = recorded_values(result);
  read.drifts = recorded_drifts(result);
  read.plates = recorded_plates(result);
  read.calibrations = recorded_calibrations(result);
  read.articulations = recorded_articulations(result);
  read.volumetric = recorded_volumetric(result);
  if (result.has("features")) {
    read.features = recorded_features(result);
  }
  read.arm_path = recorded_arm_path(result);
  return read;
}

}  // namespace artcal
