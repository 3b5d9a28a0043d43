#include "app/results/evaluation/evaluation_json.h"

#include "app/output/json_list.h"
#include "app/results/artefact_summary.h"
#include "app/results/identification/result_json.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json deviation_json(const FeatureDeviation& deviation) {
  Json json;
  for (const auto& [key, name] :
       {std::pair{"artefact", &deviation.name.artefact}, std::pair{"placement", &deviation.name.placement},
        std::pair{"feature", &deviation.name.feature}}) {
    if (!name->empty()) {
      json[key] = *name;
    }
  }
  json["readings"] = deviation.readings;
  json["rms_mm"] = deviation.rms;
  json["maximum_mm"] = deviation.maximum;
  return json;
}

Json length_json(const LengthDeviation& length) {
  return {{"artefact", length.first.artefact},
          {"placement", length.first.placement},
          {"first", length.first.feature},
          {"second", length.second},
          {"certified_mm", length.certified.value},
          {"certified_at_C", length.certified.temperature},
          {"at_temperature_mm", length.at_temperature},
          {"error_mm", length.error}};
}

Json features_json(const Evaluation& evaluation) {
  Json json = json_list(evaluation.features, deviation_json);
  for (std::size_t i = 0; i < json.size(); ++i) {
    json[i]["at_mm"] = point_json(evaluation.points[i]);
  }
  return json;
}

Json readings_json(const Recording& recording, const Constraints& constraints, const Evaluation& evaluation) {
  Json json = Json::array();
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const FeatureName& name = evaluation.features[f].name;
    for (const int reading : constraints.features[f].readings) {
      const std::size_t i = json.size();
      json.push_back({{"where", recording.where(reading)},
                      {"artefact", name.artefact},
                      {"placement", name.placement},
                      {"feature", name.feature},
                      {"deviation_mm", evaluation.deviations[i]},
                      {"tip_mm", point_json(evaluation.tips[i])},
                      {"offset_mm", point_json(evaluation.offsets[i])}});
    }
  }
  return json;
}

}  // namespace

Json evaluation_json(const Evaluation& evaluation) {
  return {{"overall", deviation_json(evaluation.overall)},
          {"artefacts", json_list(evaluation.artefacts, deviation_json)},
          {"placements", json_list(evaluation.placements, deviation_json)},
          {"features", features_json(evaluation)},
          {"lengths", json_list(evaluation.lengths, length_json)}};
}

Json to_json(const Recording& recording, const Constraints& constraints, const Evaluation& evaluation) {
  Json json = result_header(recording, "evaluation", std::nullopt);
  json["date"] = recording.date.empty() ? Json(nullptr) : Json(recording.date);
  json["counts"] = {{"readings", recording.readings.size()},
                    {"features", constraints.features.size()},
                    {"placements", evaluation.placements.size()},
                    {"artefacts", evaluation.artefacts.size()}};
  json["artefacts"] = artefacts_json(constraints.artefacts);
  json["evaluation"] = evaluation_json(evaluation);
  json["readings"] = readings_json(recording, constraints, evaluation);
  json["warnings"] = recording.warnings;
  return json;
}

Json left_out_json(const LeftOut& left) {
  Json json = deviation_json(left.deviation);
  json["lengths"] = json_list(left.lengths, length_json);
  json["refusal"] = left.refusal.empty() ? Json(nullptr) : Json(left.refusal);
  return json;
}

}  // namespace artcal
