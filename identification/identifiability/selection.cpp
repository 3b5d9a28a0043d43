#include "identification/identifiability/selection.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/arm/forward_kinematics.h"
#include "core/contains.h"
#include "identification/identifiability/unidentifiable_text.h"

namespace artcal {
namespace {

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

// What is known unless it is asked about.
bool is_beside(const Parameter& parameter) {
  return parameter.kind == ParameterKind::Radius || parameter.is_joint_error();
}

// Whether both parameters of a pair move every tip of the arm along the same line, in the same proportion.
bool is_one_sum(Arm arm, const WristPair& pair) {
  const auto all = parameters_of(arm);
  const std::vector<Parameter> both{all[find_parameter(all, pair.first)], all[find_parameter(all, pair.second)]};
  std::vector<double> sines;
  for (Joint& joint : arm.joints) {
    joint.errors = {};
    sines.insert(sines.end(), {0.0, 1.0});  // one posture will do: both move the tip in the last joint's own frame
  }
  const std::vector<double> q(arm.joints.size(), 0.0);
  Eigen::MatrixX2d moves(3 * std::ssize(arm.probes), 2);
  for (int probe = 0; probe < static_cast<int>(arm.probes.size()); ++probe) {
    std::vector<double> by_both(6);
    ForwardKinematics(arm, both, probe).tip_in_base({sines, q}, by_both.data());
    moves.middleRows<3>(3 * probe) = Eigen::Matrix<double, 3, 2>::Map(by_both.data());
  }
  moves.col(1) /= std::max(1.0, reach(arm));
  const double sizes = moves.col(0).norm() * moves.col(1).norm();
  const double across = std::sqrt(std::max(0.0, sizes * sizes - std::pow(moves.col(0).dot(moves.col(1)), 2)));
  return moves.col(1).norm() > 1e-9 && across < 1e-7 * sizes;
}

// Whether the readings identify any member of a group, given which motions are unidentifiable. A member that they do
// not identify alone is fixed like any other parameter, and the rest of the group stays.
Expected<void> check_group(const Selection::Group& group, const Coupling& coupling) {
  std::string unidentifiable;
  std::size_t count = 0;
  for (const ParameterMotion& motion : coupling.unidentifiable) {
    if (contains(group.members, coupling.parameters[motion.leading].name)) {
      ++count;
      unidentifiable += (unidentifiable.empty() ? "" : "; ") + unidentifiable_in_words(coupling, motion);
    }
  }
  if (count < group.members.size()) {
    return {};
  }
  return no_solution(
      fmt::format("the group {} was asked for, but these readings identify no parameter of it: {}. Leave it out of the "
                  "model",
                  name_of(group.group), unidentifiable));
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
                                      const std::vector<std::string>& free, const Model& model) {
  const auto parameters = all_parameters(arm);
  for (const auto& checked : {check_names(parameters, hold, "hold"), check_names(parameters, free, "free")}) {
    if (!checked) {
      return tl::unexpected(checked.error());
    }
  }
  for (const auto& name : free) {
    if (contains(hold, name)) {
      return wrong_usage(fmt::format("{} cannot be both fixed and free", name));
    }
  }
  Selection selection{hold, {}, free, {}, {}};
  for (const auto& name : free) {
    if (is_beside(parameters[find_parameter(parameters, name)])) {
      selection.beside.push_back(name);
    }
  }
  for (const ParameterGroup group : model) {
    Selection::Group added{group, {}};
    for (const Parameter& parameter : members_of(group, arm)) {
      if (contains(hold, parameter.name)) {
        continue;
      }
      added.members.push_back(parameter.name);
      if (is_beside(parameter) && !contains(selection.beside, parameter.name)) {
        selection.beside.push_back(parameter.name);
      }
    }
    if (added.members.empty()) {
      return wrong_usage(fmt::format("the model has the group {}, but nothing of it is left to identify for this arm",
                                     name_of(group)));
    }
    selection.groups.push_back(std::move(added));
  }
  for (const auto& name : offsets_replaced_by_beta(arm, hold)) {
    if (!contains(free, name) && !contains(hold, name)) {
      selection.fixed_first.push_back(name);
    }
  }
  for (const WristPair& pair : wrist_pairs(arm)) {
    if (contains(free, pair.first) && contains(free, pair.second) && is_one_sum(arm, pair)) {
      return wrong_usage(
          fmt::format("{} and {} are never identified together: readings determine only one sum of the two; "
                      "free one of them",
                      pair.first, pair.second));
    }
    selection.fixed_first.push_back(contains(free, pair.first) ? pair.second : pair.first);
  }
  return selection;
}

Selection of_chain(const Selection& selection) {
  Selection chain = selection;
  chain.groups.clear();
  std::erase_if(chain.beside, [&](const std::string& name) { return !contains(selection.rather_free, name); });
  return chain;
}

CouplingOptions coupling_options(const Selection& selection) {
  CouplingOptions options;
  options.not_asked = selection.fixed;
  options.beside_asked = selection.beside;
  // The last joint's pairs, then members of groups: an unidentifiable motion that they take part in beside is told by
  // them.
  options.preferred_fixed = selection.fixed_first;
  for (const Selection::Group& group : selection.groups) {
    options.preferred_fixed.insert(options.preferred_fixed.end(), group.members.begin(), group.members.end());
  }
  options.rather_free = selection.rather_free;
  return options;
}

Expected<std::vector<Parameter>> free_parameters(const Selection& selection, const Coupling& coupling) {
  for (const Selection::Group& group : selection.groups) {
    if (auto told = check_group(group, coupling); !told) {
      return tl::unexpected(told.error());
    }
  }
  std::vector<bool> fixed(coupling.parameters.size(), false);
  for (const auto& motion : coupling.unidentifiable) {
    const std::string& name = coupling.parameters[motion.leading].name;
    if (contains(selection.rather_free, name)) {
      return no_solution(fmt::format("{} was asked to be free, but these readings cannot determine it: {}", name,
                                     unidentifiable_in_words(coupling, motion)));
    }
    fixed[motion.leading] = true;
  }
  std::vector<Parameter> free;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (!fixed[i]) {
      free.push_back(coupling.parameters[i]);
    }
  }
  return free;
}

}  // namespace artcal
