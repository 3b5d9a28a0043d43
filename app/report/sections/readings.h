#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "app/report/sheet.h"

namespace artcal {

/// The readings of an identification, as its JSON has them under "residuals"; NaN where a number was not known.
struct ReportedReadings {
  std::vector<int> feature;                 ///< into after.features, ascending
  std::vector<std::vector<double>> joints;  ///< one list a joint, rad
  std::vector<double> before, after;        ///< mm
  std::vector<std::vector<double>> tip;     ///< x, y, z, mm
  std::vector<std::vector<double>> offset;  ///< x, y, z, mm
  std::vector<int> prismatic;               ///< numbers of joints whose readings are mm
};

/// Throws std::exception where columns are missing, of different lengths, or name a feature that is not there.
ReportedReadings readings_in(const nlohmann::ordered_json& identification);

/// What each reading deviates by, in the order of the placements.
Figure residuals_by_placement(const nlohmann::ordered_json& identification, const ReportedReadings& readings);

/// The same against the angle of each joint: a wave shows an eccentric encoder.
Figure residuals_by_joint(const ReportedReadings& readings);

}  // namespace artcal
