#include "app/results/identification/evaluation_json.h"

#include "app/output/json_list.h"

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
    const Eigen::Vector3d& point = evaluation.points[i];
    json[i]["at_mm"] = {point.x(), point.y(), point.z()};
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

Json left_out_json(const LeftOut& left) {
  Json json = deviation_json(left.deviation);
  json["lengths"] = json_list(left.lengths, length_json);
  json["refusal"] = left.refusal.empty() ? Json(nullptr) : Json(left.refusal);
  return json;
}

}  // namespace artcal
