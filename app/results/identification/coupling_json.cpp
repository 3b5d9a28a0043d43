#include "app/results/identification/coupling_json.h"

#include "app/results/identification/result_json.h"
#include "identification/identifiability/unidentifiable_text.h"

namespace artcal {
using Json = nlohmann::ordered_json;

Json motion_json(const Coupling& coupling, const ParameterMotion& motion) {
  Json coefficients = Json::object();
  for (Eigen::Index i = 0; i < motion.coefficients.size(); ++i) {
    if (motion.coefficients[i] != 0.0) {
      coefficients[coupling.parameters[i].name] = motion.coefficients[i];
    }
  }
  return coefficients;
}

namespace {

const char* scale_state_name(ScaleState state) {
  switch (state) {
    case ScaleState::Unidentifiable: return "unidentifiable";
    case ScaleState::Weak: return "weak";
    case ScaleState::Determined: break;
  }
  return "determined";
}

const char* reading_kind_name(ReadingKind kind) {
  switch (kind) {
    case ReadingKind::BaseCoordinates: return "base";
    case ReadingKind::FrameCoordinates: return "frame";
    case ReadingKind::Point: return "point";
    case ReadingKind::Distance: return "distance";
    case ReadingKind::Plate: return "plate";
    case ReadingKind::Sphere: return "sphere";
    case ReadingKind::UnknownSphere: return "sphere-unknown-radius";
    case ReadingKind::Plane: return "plane";
    case ReadingKind::LevelPlane: return "plane-perpendicular";
    case ReadingKind::Length: break;
  }
  return "length";
}

}  // namespace

Json coupling_json(const Coupling& coupling) {
  Json json;
  json["parameter_count"] = coupling.parameters.size();
  json["rank"] = coupling.rank;
  json["residual_count"] = coupling.residual_count;
  json["unknown_count"] = coupling.unknown_count;
  json["angle_scale_mm"] = coupling.angle_scale;
  json["singular_values"] = std::vector<double>(coupling.singular_values.begin(), coupling.singular_values.end());
  json["scale"] = scale_state_name(coupling.scale);
  json["unidentifiable"] = Json::array();
  for (const ParameterMotion& motion : coupling.unidentifiable) {
    json["unidentifiable"].push_back({{"fixed", coupling.parameters[motion.leading].name},
                                      {"text", unidentifiable_in_words(coupling, motion)},
                                      {"motion", motion_json(coupling, motion)}});
  }
  json["weak"] = Json::array();
  for (const WeakDirection& weak : coupling.weak) {
    json["weak"].push_back({{"singular_value", weak.singular_value},
                            {"text", weak_in_words(coupling, weak)},
                            {"share_of_scale", weak.share_of_scale},
                            {"motion", motion_json(coupling, weak.motion)}});
  }
  json["readings_not_moved"] = coupling.readings_not_moved;
  return json;
}

Json to_json(const Recording& recording, const Coupling& coupling, const CouplingRequest& request) {
  const auto& made_up = request.made_up;
  Json json = result_header(recording, "coupling", made_up ? std::optional(made_up->seed) : std::nullopt);
  json["options"] = {{"hold", request.hold}, {"free", request.free}, {"model", request.model}};
  json["made_up"] = nullptr;
  if (made_up) {
    json["made_up"] = {
        {"kind", reading_kind_name(made_up->kind)}, {"readings", made_up->readings}, {"features", made_up->features}};
  }
  json["coupling"] = coupling_json(coupling);
  json["warnings"] = recording.warnings;
  return json;
}

}  // namespace artcal
