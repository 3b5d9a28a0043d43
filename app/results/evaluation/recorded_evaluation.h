#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace artcal {

/// Deviations of readings as a result has them (table "deviation" of docs/result-schema.md), mm; NaN where an arm could
/// not be evaluated.
struct RecordedDeviation {
  std::string artefact, placement;
  std::size_t readings = 0;
  double rms = std::numeric_limits<double>::quiet_NaN();
  double maximum = std::numeric_limits<double>::quiet_NaN();
};

/// A certified length as an arm measures it (table "length"), mm and °C.
struct RecordedLength {
  std::string artefact, placement, first, second;
  double at_temperature = 0.0;                              ///< certified, at the temperature of the placement
  std::optional<double> certified;                          ///< by the certificate; not in results of earlier versions
  std::optional<double> certified_at;                       ///< the temperature that this is stated at
  double error = std::numeric_limits<double>::quiet_NaN();  ///< measured less certified; NaN as above
};

/// The readings of a recording judged by one arm (table "evaluation").
struct RecordedEvaluation {
  RecordedDeviation overall;
  std::vector<RecordedDeviation> placements;
  std::vector<RecordedLength> lengths;
};

/// A placement judged by an arm that was identified without it (table "left_out").
struct RecordedLeftOut {
  RecordedDeviation deviation;
  std::vector<RecordedLength> lengths;
  bool is_refused = false;
};

/// Each throws std::exception where the JSON is not as the schema says.
RecordedEvaluation recorded_evaluation(const nlohmann::ordered_json& evaluation);
std::vector<RecordedLeftOut> recorded_left_out(const nlohmann::ordered_json& left_out);

}  // namespace artcal
