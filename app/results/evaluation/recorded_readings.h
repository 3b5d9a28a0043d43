#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/results/recorded/recorded_object.h"

namespace artcal {

/// The readings of an identification, column by column (table "residuals" of docs/result-schema.md); NaN where a number
/// was not known. All columns have as many numbers as there are readings.
struct RecordedReadings {
  std::vector<std::size_t> feature;         ///< into after.features
  std::vector<std::vector<double>> joints;  ///< one list a joint, rad, of a prismatic joint mm
  std::vector<double> before, after;        ///< mm
  std::vector<std::vector<double>> tip;     ///< x, y, z, mm
  std::vector<std::vector<double>> offset;  ///< x, y, z, mm
  std::vector<std::size_t> prismatic;       ///< numbers of joints whose readings are mm, from 1
};

/// Nothing where the result was written without them. Throws NotAsInSchema, also where columns are of different
/// lengths, or name a feature that is not there.
std::optional<RecordedReadings> recorded_readings(const RecordedObject& identification, std::size_t features);

}  // namespace artcal
