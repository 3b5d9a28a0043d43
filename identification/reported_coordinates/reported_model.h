#pragma once

#include <optional>

#include "identification/identify.h"
#include "identification/reported_coordinates/joint_assignment.h"

namespace artcal {

struct ReportedModelOptions {
  bool base_frame_is_known = true;  ///< the coordinates are in the arm's base frame; or in one at an unknown pose
  IdentifyOptions identify;         ///< hold, free, model, noise
};

/// The model that an arm's own software computes coordinates by, found from joint readings and these coordinates.
struct ReportedModel {
  JointAssignment assignment;
  Recording recording;  ///< joints as assigned, arm with its signs, the coordinates as references
  Constraints constraints;
  Identification identification;
  int tried = 0;                         ///< assignments that were identified with
  std::optional<double> next_best = {};  ///< rms of up to 80 readings with the next best of these, mm
};

/// Identifies the arm for the likely assignments of columns, signs and units (likely_assignments()) from up to 80
/// readings, takes the one that leaves clearly the smallest residuals, and with it all readings; orders other than that
/// of the columns are tried where that one leads to no solution. Each reading's coordinates are those of Reading::tip,
/// or of Reading::reference where there are none.
///
/// Bad input: a reading without joints or coordinates. No solution: none of the assignments leads to an arm that fits.
Expected<ReportedModel> identify_reported_model(const Recording& recording, const ReportedModelOptions& options);

}  // namespace artcal
