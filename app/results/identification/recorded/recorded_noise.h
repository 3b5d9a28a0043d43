#pragma once

#include <cstddef>
#include <optional>

#include "app/results/recorded/recorded_object.h"

namespace artcal {

/// The noise of the readings as a result has it, and whether they agree with it (table "noise" of
/// docs/result-schema.md).
struct RecordedNoise {
  double noise = 0.0;  ///< of a coordinate, mm
  bool is_given = false;
  double chi_squared = 0.0;
  int degrees_of_freedom = 0;
  double chi_squared_low = 0.0, chi_squared_high = 0.0;  ///< 95 of 100 sound fits lie between them
  double scale_factor = 1.0;
};

/// Errors of the placements left out against their standard uncertainties (table "cross_validation").
struct RecordedCrossValidation {
  std::size_t placements = 0;
  double ratio = 0.0;     ///< rms
  double ratio_99 = 0.0;  ///< 99 of 100 sound recordings are below it
  double scale = 1.0;     ///< factor in all standard uncertainties
};

/// Both throw NotAsInSchema. Nothing: no placement left out could be checked, or an earlier version did not.
RecordedNoise recorded_noise(const RecordedObject& identification);
std::optional<RecordedCrossValidation> recorded_cross_validation(const RecordedObject& identification);

}  // namespace artcal
