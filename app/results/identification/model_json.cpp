#include "app/results/identification/model_json.h"

#include "app/output/json_list.h"
#include "app/results/hayati_angles.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

const char* effect_name(Effect effect) {
  switch (effect) {
    case Effect::OncePerTurn: return "once-per-turn";
    case Effect::TwicePerTurn: return "twice-per-turn";
    case Effect::Gain: return "gain";
    case Effect::Gravity: return "gravity";
    case Effect::Drift: return "drift";
    case Effect::TemperatureOffset: return "temperature_offset";
    case Effect::Expansion: break;
  }
  return "expansion";
}

// Joints are counted from 1, as parameters are; what concerns the arm as a whole has none.
Json joint_json(Effect effect, int joint) { return effect == Effect::Expansion ? Json(nullptr) : Json(joint + 1); }

const char* verdict_name(ModelTrial::Verdict verdict) {
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
          {"verdict", verdict_name(trial.verdict)},
          {"refusal", is_known ? Json(nullptr) : Json(trial.refusal)},
          {"parameters", is_known ? Json(trial.parameters) : Json(nullptr)},
          {"left_out_rms_mm", is_known ? Json(trial.left_out_rms) : Json(nullptr)},
          {"improvement", is_compared ? Json(trial.improvement) : Json(nullptr)},
          {"improvement_noise", is_compared ? Json(trial.improvement_noise) : Json(nullptr)},
          {"limit", is_compared ? Json(trial.limit) : Json(nullptr)}};
}

const char* reason_name(FixedMember::Reason reason) {
  switch (reason) {
    case FixedMember::Reason::Undetermined: return "weakly identifiable";
    case FixedMember::Reason::Implausible: return "implausible";
    case FixedMember::Reason::BelowZero: return "below zero";
    case FixedMember::Reason::NotIdentifiable: break;
  }
  return "not identifiable";
}

Json fixed_member_json(const FixedMember& member) {
  const bool estimated =
      member.reason == FixedMember::Reason::Implausible || member.reason == FixedMember::Reason::BelowZero;
  return {{"name", member.name},
          {"group", name_of(member.group)},
          {"reason", reason_name(member.reason)},
          {"estimate", estimated ? Json(member.estimate) : Json(nullptr)},
          {"standard_uncertainty", estimated ? Json(member.u) : Json(nullptr)},
          {"text", member.why}};
}

}  // namespace

Json model_study_json(const ModelStudy& study) {
  return {{"done", study.done},
          {"false_alarms", study.false_alarms},
          {"readings", study.readings},
          {"implausible", study.implausible},
          {"remaining_variance", study.remaining_variance},
          {"tests", json_list(study.tests,
                              [](const ModelTest& test) -> Json {
                                return {{"effect", effect_name(test.effect)},
                                        {"joint", joint_json(test.effect, test.joint)},
                                        {"columns", test.columns},
                                        {"chi_squared", test.chi_squared},
                                        {"p", test.p}};
                              })},
          {"findings", json_list(study.findings, [](const ModelFinding& finding) -> Json {
             const bool periodic = finding.effect == Effect::OncePerTurn || finding.effect == Effect::TwicePerTurn;
             return {{"effect", effect_name(finding.effect)},
                     {"joint", joint_json(finding.effect, finding.joint)},
                     {"text", in_words(finding)},
                     {"p", finding.p},
                     {"amplitude", finding.amplitude},
                     {"u_amplitude", finding.effect == Effect::Gravity ? Json(nullptr) : Json(finding.u_amplitude)},
                     {"phase_rad", periodic ? Json(finding.phase) : Json(nullptr)},
                     {"rms_at_tip_mm", finding.rms_at_tip}};
           })}};
}

Json model_json(const Identification& result) {
  Json groups = Json::array();
  for (const ParameterGroup group : result.model) {
    groups.push_back(name_of(group));
  }
  return {{"text", model_text(result.model)},
          {"groups", groups},
          {"hayati", json_list(hayati_angles(result),
                               [](const HayatiAngle& each) -> Json {
                                 return {{"angle", each.angle}, {"in_place_of", each.offset}};
                               })},
          {"fixed", json_list(result.fixed_members, fixed_member_json)},
          {"trials", json_list(result.trials, trial_json)},
          {"chosen_by_left_out", result.left_out_chose_the_model}};
}

}  // namespace artcal
