#pragma once

#include <string>

#include "acquisition/import/imported_readings.h"

namespace artcal {

/// Fits the spheres, circles (in a plane of the reported normal) and cylinders that the other program reported to their
/// points by least squares, and says by how much centres and diameters differ: what was understood of names, points,
/// unit and tip is then right or visibly wrong. `mm` and `tip_radius_mm`: the unit and the tip of the points. Empty
/// where nothing was reported.
std::string feature_check(const ImportedReadings& readings, double mm, double tip_radius_mm);

}  // namespace artcal
