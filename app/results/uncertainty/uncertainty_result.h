#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "acquisition/arm/arm_file.h"
#include "identification/uncertainty/working_volume.h"

namespace artcal {

/// What `artcal uncertainty` found, and from what.
struct SurveyResult {
  ArmFile file;
  UncertaintySources sources;
  int probe = 0;
  VolumeSampling sampling;
  WorkingVolume volume;
};

nlohmann::ordered_json to_json(const SurveyResult& result);
std::string to_text(const SurveyResult& result);

/// A line that says how warm an arm is when it measures; empty for one that does not expand.
std::string at_what_temperature(const Arm& arm);

}  // namespace artcal
