#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/results/fit/feature_fit.h"

namespace artcal {

/// A fit and what it was made of.
struct FitReport {
  FitRequest request;
  std::vector<InputFile> inputs;  ///< the points, and the list of rows if there was one
  std::size_t records = 0;        ///< of the file, dropped ones among them
  std::size_t dropped = 0;
  std::string columns;  ///< ReadCloud::columns
  FeatureFit fit;
  std::vector<std::string> warnings;
  double reading_seconds = 0.0, fitting_seconds = 0.0;
};

/// For a person.
std::string to_text(const FitReport& report);

/// The table `fit` of docs/result-schema.md.
nlohmann::ordered_json to_json(const FitReport& report);

}  // namespace artcal
