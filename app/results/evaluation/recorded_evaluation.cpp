#include "app/results/evaluation/recorded_evaluation.h"

#include "app/results/recorded_json.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> number_at(const Json& json, const char* key) {
  return json.contains(key) ? std::optional(json.at(key).get<double>()) : std::nullopt;
}

RecordedDeviation deviation_from(const Json& json) {
  return {recorded_text(json, "artefact"), recorded_text(json, "placement"), json.at("readings").get<std::size_t>(),
          recorded_number(json.at("rms_mm")), recorded_number(json.at("maximum_mm"))};
}

// Results of earlier versions have the length at the temperature of the placement alone, as `certified_mm`.
RecordedLength length_from(const Json& json) {
  RecordedLength length;
  length.artefact = recorded_text(json, "artefact");
  length.placement = recorded_text(json, "placement");
  length.first = recorded_text(json, "first");
  length.second = recorded_text(json, "second");
  length.certified_at = number_at(json, "certified_at_C");
  length.certified = length.certified_at ? number_at(json, "certified_mm") : std::nullopt;
  length.at_temperature = json.at(json.contains("at_temperature_mm") ? "at_temperature_mm" : "certified_mm");
  length.error = recorded_number(json.at("error_mm"));
  return length;
}

std::vector<RecordedLength> lengths_from(const Json& list) {
  std::vector<RecordedLength> lengths;
  for (const Json& json : list) {
    lengths.push_back(length_from(json));
  }
  return lengths;
}

}  // namespace

RecordedEvaluation recorded_evaluation(const Json& evaluation) {
  RecordedEvaluation read;
  read.overall = deviation_from(evaluation.at("overall"));
  for (const Json& json : evaluation.at("placements")) {
    read.placements.push_back(deviation_from(json));
  }
  read.lengths = lengths_from(evaluation.at("lengths"));
  return read;
}

std::vector<RecordedLeftOut> recorded_left_out(const Json& left_out) {
  std::vector<RecordedLeftOut> read;
  for (const Json& json : left_out) {
    read.push_back({deviation_from(json), lengths_from(json.at("lengths")), !json.at("refusal").is_null()});
  }
  return read;
}

}  // namespace artcal
