#pragma once

#include <filesystem>

#include "acquisition/recording/recording.h"
#include "core/error.h"

namespace artcal {

/// Factors from the units of a readings file to those of artcal.
struct ReadingUnits {
  double joint = 1.0;
  double length = 1.0;
};

/// Reads a CSV of readings and appends them to `recording`, whose arm must be known. Columns: artefact,
/// placement, feature, orientation, repeat, probe, temperature, length, ref_x, ref_y, ref_z, x, y, z and
/// q1 … qn, which may be absent where x, y, z are there: Recording::joints then holds NaN for them. Columns that begin
/// with x- are the user's own and are passed over. After an error `recording` may hold part of the file and is of no
/// use. Format: docs/files.md.
Expected<void> read_readings(const std::filesystem::path& path, const ReadingUnits& units, Recording& recording);

/// Joint angles whose size fits the other unit better: a sentence for each such suspicion.
std::vector<std::string> suspicious_angles(const Recording& recording, double joint_unit);

}  // namespace artcal
