#pragma once

#include <string>

#include "app/results/recorded/recorded_object.h"
#include "identification/uncertainty/working_volume.h"

namespace artcal {

/// What an identified arm measures like, as a result has it (table "uncertainty_result" of docs/result-schema.md).
struct RecordedUncertainty {
  std::string probe;
  double encoder = 0.0;  ///< noise of a joint's reading, rad; 0: none is stated
  double probing = 0.0;  ///< noise of a coordinate beside it, mm
  WorkingVolume volume;
};

/// Throws NotAsInSchema.
RecordedUncertainty recorded_uncertainty(const RecordedObject& result);

}  // namespace artcal
