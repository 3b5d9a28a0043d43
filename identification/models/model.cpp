#include "identification/models/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/arm/parallel_axes.h"
#include "acquisition/recording/tip_centres.h"
#include "core/contains.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::array<std::string_view, parameter_groups> names{
    "eccentricity", "eccentricity2", "gain", "coupling", "gravity", "thermal", "hayati", "tip", "radius"};

// Of the reach: what is shorter does not grow by anything to speak of.
constexpr double no_link = 0.01;

bool is_long(const Arm& arm, int joint) {
  const Joint& link = arm.joints[static_cast<std::size_t>(joint)];
  // The last link ends in the tip.
  return joint + 1 == static_cast<int>(arm.joints.size()) || std::hypot(link.a, link.d) > no_link * reach(arm);
}

bool is_member(ParameterGroup group, const Parameter& parameter, const Arm& arm) {
  using Kind = ParameterKind;
  const Kind kind = parameter.kind;
  switch (group) {
    case ParameterGroup::Eccentricity: return kind == Kind::Cosine1 || kind == Kind::Sine1;
    case ParameterGroup::SecondEccentricity: return kind == Kind::Cosine2 || kind == Kind::Sine2;
    case ParameterGroup::Gain: return kind == Kind::Gain;
    case ParameterGroup::Coupling: return kind == Kind::Coupling;
    case ParameterGroup::Gravity: return kind == Kind::Compliance;
    case ParameterGroup::Thermal: return kind == Kind::Expansion && is_long(arm, parameter.owner);
    case ParameterGroup::Hayati:
      return kind == Kind::Beta && joins_parallel_axes(arm, static_cast<std::size_t>(parameter.owner));
    case ParameterGroup::Tip: return kind == Kind::TipX || kind == Kind::TipY;
    case ParameterGroup::Radius: return kind == Kind::Radius;
  }
  return false;
}

Error unknown_group(std::string_view text, std::string_view name) {
  return {ErrorCode::Usage,
          fmt::format("the model {} names {}, expected \"auto\", \"dh\" or \"dh\" with any of {} behind it, such as "
                      "\"dh+eccentricity+gain\"",
                      in_quotes(std::string(text)), in_quotes(std::string(name)), fmt::join(names, ", ")),
          {}};
}

}  // namespace

std::string_view name_of(ParameterGroup group) { return names[static_cast<std::size_t>(group)]; }

std::string model_text(const Model& model) {
  std::string text = "dh";
  for (const ParameterGroup group : model) {
    text += fmt::format("+{}", name_of(group));
  }
  return text;
}

Expected<ModelRequest> model_request(std::string_view text) {
  if (text == "auto") {
    return ModelRequest{{}, true};
  }
  ModelRequest request;
  bool is_first = true;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('+', begin), text.size());
    const std::string_view name = text.substr(begin, end - begin);
    begin = end + 1;
    if (is_first) {
      is_first = false;
      if (name != "dh") {
        return tl::unexpected(unknown_group(text, name));
      }
      continue;
    }
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      return tl::unexpected(unknown_group(text, name));
    }
    const auto group = static_cast<ParameterGroup>(found - names.begin());
    if (contains(request.groups, group)) {
      return wrong_usage(
          fmt::format("the model {} names {} twice", in_quotes(std::string(text)), in_quotes(std::string(name))));
    }
    request.groups.push_back(group);
  }
  return request;
}

Arm arm_for(const Model& model, Arm arm) {
  arm = with_hayati_angles(std::move(arm));
  if (contains(model, ParameterGroup::Tip)) {
    for (Probe& probe : arm.probes) {
      probe.on_axis = false;
    }
  }
  return arm;
}

std::vector<Parameter> members_of(ParameterGroup group, const Arm& arm) {
  std::vector<Parameter> members = all_parameters(arm);
  std::erase_if(members, [&](const Parameter& parameter) { return !is_member(group, parameter, arm); });
  return members;
}

std::vector<std::string> offsets_replaced_by_beta(const Arm& arm, const std::vector<std::string>& hold) {
  const auto all = parameters_of(arm);
  std::vector<std::string> replaced;
  for (const Parameter& parameter : all) {
    const auto joint = static_cast<std::size_t>(parameter.owner);
    if (parameter.kind != ParameterKind::Beta || !joins_parallel_axes(arm, joint) ||
        std::find(hold.begin(), hold.end(), parameter.name) != hold.end()) {
      continue;
    }
    replaced.push_back(std::find_if(all.begin(), all.end(), [&](const Parameter& other) {
                         return other.kind == ParameterKind::D && other.owner == parameter.owner;
                       })->name);
  }
  return replaced;
}

std::string obstacle_to(ParameterGroup group, const Arm& arm, const Recording& recording) {
  if (group == ParameterGroup::Gravity && !has_masses(arm)) {
    return "not every joint of the arm states the mass of its link, `mass_kg` (in proportion will do)";
  }
  if (group == ParameterGroup::Thermal) {
    const auto there = require_arm_temperatures(recording);
    return there ? "" : "the readings do not all say the arm's temperature, `arm_temperature`";
  }
  if (group == ParameterGroup::Hayati) {
    if (!parallel_axes(arm).empty()) {
      return "";
    }
    return "no neighbouring axes are parallel to within 5 degrees";
  }
  if (group == ParameterGroup::Tip &&
      std::none_of(arm.probes.begin(), arm.probes.end(), [](const Probe& probe) { return probe.on_axis; })) {
    return "no tip is stated on the last axis (`l`): lx, ly and lz are parameters already";
  }
  return "";
}

}  // namespace artcal
