#include "identification/selection.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "identification/lost_text.h"

namespace artcal {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Expected<void> check_names(const std::vector<Parameter>& parameters, const std::vector<std::string>& names,
                           std::string_view option) {
  for (const auto& name : names) {
    if (find_parameter(parameters, name) < 0) {
      std::vector<std::string> known;
      for (const auto& parameter : parameters) {
        known.push_back(parameter.name);
      }
      return wrong_usage(fmt::format("{} names \"{}\", which is not a parameter of this arm; it has {}", option, name,
                                     fmt::join(known, ", ")));
    }
  }
  return {};
}

}  // namespace

std::vector<WristPair> wrist_pairs(const Arm& arm) {
  if (arm.convention == Convention::Modified) {
    return {};
  }
  const auto n = arm.joints.size();
  return {{fmt::format("a{}", n), fmt::format("theta{}", n)}, {fmt::format("d{}", n), fmt::format("alpha{}", n)}};
}

Expected<Selection> select_parameters(const Arm& arm, const std::vector<std::string>& hold,
                                      const std::vector<std::string>& free) {
  const auto parameters = parameters_with_radii(arm);
  for (const auto& checked : {check_names(parameters, hold, "hold"), check_names(parameters, free, "free")}) {
    if (!checked) {
      return tl::unexpected(checked.error());
    }
  }
  for (const auto& name : free) {
    if (contains(hold, name)) {
      return wrong_usage(fmt::format("{} cannot be both held and free", name));
    }
  }
  Selection selection{hold, {}, free, {}};
  for (const auto& name : free) {
    if (parameters[find_parameter(parameters, name)].kind == ParameterKind::Radius) {
      selection.radii.push_back(name);
    }
  }
  for (const WristPair& pair : wrist_pairs(arm)) {
    if (contains(free, pair.first) && contains(free, pair.second)) {
      return wrong_usage(
          fmt::format("{} and {} are never identified together: readings tell only one sum of the two; "
                      "free one of them",
                      pair.first, pair.second));
    }
    const bool second = contains(free, pair.first) || (contains(hold, pair.second) && !contains(hold, pair.first));
    selection.pair_held.push_back(second ? pair.second : pair.first);
  }
  return selection;
}

CouplingOptions coupling_options(const Selection& selection) {
  CouplingOptions options;
  options.not_asked = selection.held;
  options.radii_asked = selection.radii;
  options.rather_held = selection.pair_held;
  options.rather_free = selection.rather_free;
  return options;
}

Expected<std::vector<Parameter>> free_parameters(const Selection& selection, const Coupling& coupling) {
  std::vector<bool> held(coupling.parameters.size(), false);
  for (const auto& motion : coupling.lost) {
    const std::string& name = coupling.parameters[motion.leading].name;
    if (contains(selection.rather_free, name)) {
      return no_solution(fmt::format("{} was asked to be free, but these readings cannot tell it: {}", name,
                                     lost_in_words(coupling, motion)));
    }
    held[motion.leading] = true;
  }
  std::vector<Parameter> free;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i] && !contains(selection.pair_held, coupling.parameters[i].name)) {
      free.push_back(coupling.parameters[i]);
    }
  }
  return free;
}

}  // namespace artcal
