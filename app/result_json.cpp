#include "app/result_json.h"

#include "app/artefacts_told.h"
#include "app/json_list.h"
#include "app/readings_json.h"
#include "app/result_head.h"
#include "app/result_names.h"
#include "identification/lost_text.h"

namespace artcal {
namespace {

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

const char* name_of(ScaleState state) {
  switch (state) {
    case ScaleState::Lost: return "lost";
    case ScaleState::Weak: return "weak";
    case ScaleState::Determined: break;
  }
  return "determined";
}

const char* name_of(ReadingKind kind) {
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

const char* name_of(SharedUnknown::Quantity quantity) {
  switch (quantity) {
    case SharedUnknown::Quantity::ErrorX: return "x";
    case SharedUnknown::Quantity::ErrorY: return "y";
    case SharedUnknown::Quantity::ErrorZ: return "z";
    case SharedUnknown::Quantity::Radius: break;
  }
  return "radius";
}

const char* name_of(Loss loss) { return loss == Loss::Huber ? "huber" : loss == Loss::Cauchy ? "cauchy" : "none"; }

Json coupling_json(const Coupling& coupling) {
  Json json;
  json["parameter_count"] = coupling.parameters.size();
  json["rank"] = coupling.rank;
  json["residual_count"] = coupling.residual_count;
  json["unknown_count"] = coupling.unknown_count;
  json["angle_scale_mm"] = coupling.angle_scale;
  json["singular_values"] = std::vector<double>(coupling.singular_values.begin(), coupling.singular_values.end());
  json["scale"] = name_of(coupling.scale);
  json["lost"] = Json::array();
  for (const ParameterMotion& motion : coupling.lost) {
    json["lost"].push_back({{"held", coupling.parameters[motion.leading].name},
                            {"text", lost_in_words(coupling, motion)},
                            {"unseen_motion", motion_json(coupling, motion)}});
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

Json parameters_json(const Identification& result) {
  Json json = Json::array();
  for (const IdentifiedParameter& parameter : result.parameters) {
    const bool identified = parameter.state == ParameterState::Identified;
    json.push_back({{"name", parameter.parameter.name},
                    {"unit", parameter.parameter.unit()},
                    {"nominal", parameter.nominal},
                    {"identified", parameter.identified},
                    {"standard_uncertainty", identified ? Json(parameter.u) : Json(nullptr)},
                    {"state", result_name(parameter.state)}});
  }
  return json;
}

Json artefact_value_json(const ArtefactValue& value) {
  const bool certified = value.certified.has_value();
  return {{"artefact", value.artefact},
          {"feature", value.feature},
          {"quantity", name_of(value.quantity)},
          {"certified_mm", certified ? Json(*value.certified) : Json(nullptr)},
          {"certified_standard_uncertainty_mm", certified ? Json(value.u_certified) : Json(nullptr)},
          {"found_mm", value.found},
          {"standard_uncertainty_mm", value.u}};
}

Json covariance_json(const Identification& result) {
  Json names = Json::array();
  for (const int index : result.free) {
    names.push_back(result.parameters[index].parameter.name);
  }
  Json rows = Json::array();
  for (const auto& row : result.covariance.rowwise()) {
    rows.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return {{"parameters", names}, {"units", "mm, rad, rad/rad, rad/(N mm), 1/K"}, {"matrix", rows}};
}

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
  return {{"artefact", length.first.artefact}, {"placement", length.first.placement}, {"first", length.first.feature},
          {"second", length.second},           {"certified_mm", length.certified},    {"error_mm", length.error}};
}

Json features_json(const Evaluation& evaluation) {
  Json json = json_list(evaluation.features, deviation_json);
  for (std::size_t i = 0; i < json.size(); ++i) {
    const Eigen::Vector3d& point = evaluation.points[i];
    json[i]["at_mm"] = {point.x(), point.y(), point.z()};
  }
  return json;
}

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

const char* name_of(Effect effect) {
  switch (effect) {
    case Effect::OncePerTurn: return "once-per-turn";
    case Effect::TwicePerTurn: return "twice-per-turn";
    case Effect::Gain: return "gain";
    case Effect::Gravity: return "gravity";
    case Effect::Drift: return "drift";
    case Effect::Warmth: return "warmth";
    case Effect::Expansion: break;
  }
  return "expansion";
}

// Joints are counted from 1, as parameters are; what concerns the arm as a whole has none.
Json joint_json(Effect effect, int joint) { return effect == Effect::Expansion ? Json(nullptr) : Json(joint + 1); }

Json model_study_json(const ModelStudy& study) {
  return {{"done", study.done},
          {"false_alarms", study.false_alarms},
          {"readings", study.readings},
          {"tests", json_list(study.tests,
                              [](const ModelTest& test) -> Json {
                                return {{"effect", name_of(test.effect)},
                                        {"joint", joint_json(test.effect, test.joint)},
                                        {"columns", test.columns},
                                        {"f", test.f},
                                        {"p", test.p}};
                              })},
          {"findings", json_list(study.findings, [](const ModelFinding& finding) -> Json {
             const bool periodic = finding.effect == Effect::OncePerTurn || finding.effect == Effect::TwicePerTurn;
             return {{"effect", name_of(finding.effect)},
                     {"joint", joint_json(finding.effect, finding.joint)},
                     {"text", in_words(finding)},
                     {"p", finding.p},
                     {"amplitude", finding.amplitude},
                     {"u_amplitude", finding.effect == Effect::Gravity ? Json(nullptr) : Json(finding.u_amplitude)},
                     {"phase_rad", periodic ? Json(finding.phase) : Json(nullptr)},
                     {"rms_at_tip_mm", finding.rms_at_tip}};
           })}};
}

const char* name_of(ModelTrial::Verdict verdict) {
  switch (verdict) {
    case ModelTrial::Verdict::Taken: return "taken";
    case ModelTrial::Verdict::Worth: return "worth it, but not the best";
    case ModelTrial::Verdict::NotWorth: return "not worth it";
    case ModelTrial::Verdict::Refused: return "refused";
    case ModelTrial::Verdict::Start: break;
  }
  return "start";
}

Json trial_json(const ModelTrial& trial) {
  const bool is_known = trial.verdict != ModelTrial::Verdict::Refused;
  const bool is_compared = is_known && trial.verdict != ModelTrial::Verdict::Start;
  return {{"step", trial.step},
          {"model", model_text(trial.model)},
          {"verdict", name_of(trial.verdict)},
          {"refusal", is_known ? Json(nullptr) : Json(trial.refusal)},
          {"parameters", is_known ? Json(trial.parameters) : Json(nullptr)},
          {"left_out_rms_mm", is_known ? Json(trial.left_out_rms) : Json(nullptr)},
          {"improvement", is_compared ? Json(trial.improvement) : Json(nullptr)},
          {"improvement_noise", is_compared ? Json(trial.improvement_noise) : Json(nullptr)}};
}

Json model_json(const Identification& result) {
  Json groups = Json::array();
  for (const ParameterGroup group : result.model) {
    groups.push_back(name_of(group));
  }
  return {{"text", model_text(result.model)}, {"groups", groups}, {"trials", json_list(result.trials, trial_json)}};
}

Json noise_json(const IdentifyOptions& options, const Identification& result) {
  Json json{{"given", result.noise_is_given}, {"mm", result.noise}};
  if (options.noise.encoder) {
    json["encoder_rad"] = *options.noise.encoder;
    json["probing_mm"] = *options.noise.probing;
  }
  json["chi_squared"] = result.chi_squared;
  json["degrees_of_freedom"] = result.degrees_of_freedom;
  json["chi_squared_95"] = {result.chi_squared_low, result.chi_squared_high};
  json["enlargement"] = result.enlargement;
  return json;
}

}  // namespace

Json result_header(const Recording& recording, const char* kind, const std::optional<std::uint64_t>& seed) {
  Json json = result_head(kind);
  json["recording"] = recording.name;
  json["arm"] = recording.arm.name;
  json["inputs"] = inputs_json(recording.inputs);
  json["seed"] = seed ? Json(*seed) : Json(nullptr);
  return json;
}

Json to_json(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
             const Identification& result, const Timings& timings) {
  Json json = result_header(recording, "identification", std::nullopt);
  json["options"] = {{"hold", options.hold},
                     {"free", options.free},
                     {"loss", name_of(options.loss)},
                     {"leave_out", options.leave_out}};
  json["counts"] = {{"readings", recording.readings.size()},
                    {"features", constraints.features.size()},
                    {"placements", result.after.placements.size()},
                    {"artefacts", result.after.artefacts.size()}};
  json["model"] = model_json(result);
  json["date"] = recording.date.empty() ? Json(nullptr) : Json(recording.date);
  json["temperature"] = temperature_json(recording);
  json["artefacts"] = artefacts_json(constraints.artefacts);
  json["coupling"] = coupling_json(result.coupling);
  json["parameters"] = parameters_json(result);
  json["covariance"] = covariance_json(result);
  json["noise"] = noise_json(options, result);
  json["artefact_values"] = json_list(result.artefact_values, artefact_value_json);
  json["before"] = evaluation_json(result.before);
  json["after"] = evaluation_json(result.after);
  json["left_out"] = json_list(result.left_out, left_out_json);
  json["outliers"] = json_list(result.outliers, [&](const Outlier& outlier) -> Json {
    return {{"reading", outlier.reading},
            {"where", recording.where(outlier.reading)},
            {"artefact", outlier.name.artefact},
            {"placement", outlier.name.placement},
            {"feature", outlier.name.feature},
            {"standardised", outlier.standardised},
            {"limit", outlier.limit},
            {"deviation_mm", outlier.deviation}};
  });
  json["model_study"] = model_study_json(result.model_study);
  json["termination"] = {{"status", "converged"},
                         {"message", result.termination},
                         {"iterations", result.iterations},
                         {"rounds", result.noise_rounds},
                         {"cost", result.cost}};
  json["warnings"] = result.warnings;
  json["arm_shape"] = arm_shape_json(recording, result.arm);
  json["timings_s"] = {{"reading", timings.reading}, {"identifying", timings.identifying}};
  return json;
}

Json to_json(const Recording& recording, const Coupling& coupling, const CouplingRequest& request) {
  const auto& made_up = request.made_up;
  Json json = result_header(recording, "coupling", made_up ? std::optional(made_up->seed) : std::nullopt);
  json["options"] = {{"hold", request.hold}, {"free", request.free}, {"model", request.model}};
  json["made_up"] = nullptr;
  if (made_up) {
    json["made_up"] = {
        {"kind", name_of(made_up->kind)}, {"readings", made_up->readings}, {"features", made_up->features}};
  }
  json["coupling"] = coupling_json(coupling);
  json["warnings"] = recording.warnings;
  return json;
}

}  // namespace artcal
