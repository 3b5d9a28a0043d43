#include "identification/models/group_fit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "acquisition/arm/joint_error_keys.h"
#include "core/contains.h"
#include "identification/identifiability/svd.h"
#include "identification/identifiability/unidentifiable_text.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

using Reason = FixedMember::Reason;

/// A member of a group that is on offer to be fixed.
struct Member {
  int free = 0;  ///< index into the free parameters
  ParameterGroup group = ParameterGroup::Eccentricity;
};

std::vector<Member> members_in(const std::vector<Parameter>& free, const Arm& arm, const IdentifyOptions& options) {
  std::vector<Member> members;
  for (const ParameterGroup group : options.model) {
    for (const Parameter& parameter : members_of(group, arm)) {
      const int index = find_parameter(free, parameter.name);
      if (index >= 0 && parameter.is_joint_error() && !contains(options.free, parameter.name)) {
        members.push_back({index, group});
      }
    }
  }
  return members;
}

/// What a fit says of a member that is no error of a joint that works.
struct Finding {
  Member member;
  Reason reason = Reason::Undetermined;
  double estimate = 0.0;
  double u = 0.0;
};

std::optional<Finding> worst_of(const std::vector<Member>& members, const std::vector<Parameter>& free, const Arm& arm,
                                const Eigen::MatrixXd& covariance) {
  std::optional<Finding> worst;
  double excess = 1.0;
  double below = 0.0;  // of compliances below zero, in standard uncertainties; asked only where nothing is in excess
  for (const Member& member : members) {
    const Parameter& parameter = free[member.free];
    const double most = most_of(parameter.kind);
    const double estimate = value(arm, parameter);
    const double u = std::sqrt(covariance(member.free, member.free));
    const double size = std::max(std::abs(estimate), u) / most;
    if (size > excess || !std::isfinite(size)) {
      excess = std::isfinite(size) ? size : INFINITY;
      worst = {member, u > most ? Reason::Undetermined : Reason::Implausible, estimate, u};
    } else if (excess == 1.0 && parameter.kind == ParameterKind::Compliance && estimate / u < below) {
      below = estimate / u;
      worst = {member, Reason::BelowZero, estimate, u};
    }
  }
  return worst;
}

// The member that readings determine least, by a linearisation at an arm that was fitted without any of them.
Finding least_determined(const std::vector<Member>& members, const std::vector<Parameter>& free,
                         const Eigen::VectorXd& scale, const Linearisation& linearisation) {
  if (const auto covariance = arm_covariance(scale, linearisation)) {
    Finding least;
    double largest = -1.0;
    for (const Member& member : members) {
      const double u = std::sqrt((*covariance)(member.free, member.free));
      if (const double size = u / most_of(free[member.free].kind); size > largest) {
        largest = size;
        least = {member, Reason::Undetermined, 0.0, u};
      }
    }
    return least;
  }
  const Eigen::MatrixXd v = svd(arm_triangle(linearisation, static_cast<int>(scale.size()))).right_vectors;
  const auto part = [&](const Member& member) { return std::abs(v(member.free, v.cols() - 1)); };
  return {*std::max_element(members.begin(), members.end(),
                            [&](const Member& a, const Member& b) { return part(a) < part(b); }),
          Reason::Undetermined, 0.0, INFINITY};
}

std::string reason_text(const Parameter& parameter, const Finding& finding) {
  const std::string came_out =
      fmt::format("{:.3g} {} with a standard uncertainty of {:.2g}", finding.estimate, parameter.unit(), finding.u);
  switch (finding.reason) {
    case Reason::BelowZero: return "its estimate is below zero, " + came_out;
    case Reason::Implausible: return "its estimate is beyond what a joint that works has, " + came_out;
    case Reason::Undetermined:
    case Reason::NotIdentifiable: break;
  }
  return fmt::format("weakly identifiable: its standard uncertainty would be {:.2g} {}, more than such an error can be",
                     finding.u, parameter.unit());
}

std::vector<FixedMember> not_identifiable(const Preparation& preparation, const Arm& arm,
                                          const IdentifyOptions& options) {
  std::vector<FixedMember> fixed;
  for (const ParameterGroup group : options.model) {
    const auto members = members_of(group, arm);
    for (const ParameterMotion& motion : preparation.coupling.unidentifiable) {
      const std::string& name = preparation.coupling.parameters[motion.leading].name;
      if (find_parameter(members, name) >= 0) {
        fixed.push_back(
            {name, group, Reason::NotIdentifiable, 0.0, 0.0, unidentifiable_in_words(preparation.coupling, motion)});
      }
    }
  }
  return fixed;
}

/// The fits that follow the first, and what is fixed in the course of them.
class Fitting {
 public:
  Fitting(const Recording& recording, const Constraints& constraints, Preparation preparation,
          const IdentifyOptions& options, const WeakPrior& prior)
      : recording_(recording),
        constraints_(constraints),
        options_(options),
        prior_(prior),
        nominal_(arm_for(options.model, recording.arm)),
        preparation_(std::move(preparation)),
        fixed_(not_identifiable(preparation_, nominal_, options)) {}

  Expected<GroupFit> after(Expected<ArmFit> fit) && {
    while (true) {
      const auto members = members_in(preparation_.free, nominal_, options_);
      if (members.empty()) {
        return std::move(fit).map([&](ArmFit&& done) {
          return GroupFit{std::move(preparation_), std::move(done), std::move(fixed_)};
        });
      }
      const auto finding = fit ? finding_of(*fit, members) : without_convergence(fit.error(), members);
      if (!finding) {
        return tl::unexpected(finding.error());
      }
      if (!*finding) {
        return GroupFit{std::move(preparation_), std::move(*fit), std::move(fixed_)};
      }
      if (fit) {
        preparation_.start = fit->arm;
      }
      if (auto left = fix(**finding); !left) {
        return tl::unexpected(left.error());
      }
      fit = fit_of(preparation_.free);
    }
  }

 private:
  [[nodiscard]] Expected<ArmFit> fit_of(const std::vector<Parameter>& free) const {
    return fit_arm(recording_, constraints_, preparation_.start, free, options_.noise,
                   SolveOptions{options_.loss, options_.max_iterations}, prior_);
  }

  [[nodiscard]] Expected<std::optional<Finding>> finding_of(const ArmFit& fit,
                                                            const std::vector<Member>& members) const {
    const auto covariance = arm_covariance(fit.scale, fit.linearisation);
    if (!covariance) {
      return least_determined(members, preparation_.free, fit.scale, fit.linearisation);
    }
    // Least squares with a stated noise that is too small would take every member for well determined.
    const double squares = fit.residuals.readings_squared() + fit.residuals.certificates_squared();
    const double scale = options_.loss == Loss::None ? std::max(1.0, squares / fit.degrees_of_freedom) : 1.0;
    return worst_of(members, preparation_.free, fit.arm, scale * *covariance);
  }

  // Without any member the chain shows which of them the readings determine least; the next fit begins there.
  Expected<std::optional<Finding>> without_convergence(const Error& why, const std::vector<Member>& members) {
    std::vector<Parameter> chain = preparation_.free;
    for (const Member& member : members) {
      std::erase_if(chain, [&](const Parameter& p) { return p.name == preparation_.free[member.free].name; });
    }
    const auto fit = fit_of(chain);
    if (!fit) {
      return tl::unexpected(why);
    }
    preparation_.start = fit->arm;
    const System system = make_system(recording_, constraints_, fit->arm, preparation_.free);
    return least_determined(members, preparation_.free, system.scale,
                            linearise(system, fit->weights, options_.loss, fit->arm, fit->unknowns));
  }

  Expected<void> fix(const Finding& finding) {
    const Parameter parameter = preparation_.free[finding.member.free];
    const ParameterGroup group = finding.member.group;
    fixed_.push_back(
        {parameter.name, group, finding.reason, finding.estimate, finding.u, reason_text(parameter, finding)});
    set_value(preparation_.start, parameter, value(nominal_, parameter));
    preparation_.free.erase(preparation_.free.begin() + finding.member.free);
    const auto members = members_of(group, nominal_);
    if (std::any_of(members.begin(), members.end(),
                    [&](const Parameter& p) { return find_parameter(preparation_.free, p.name) >= 0; })) {
      return {};
    }
    std::string reasons;
    for (const FixedMember& member : fixed_) {
      if (member.group == group) {
        reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", member.name, member.why);
      }
    }
    return no_solution(fmt::format(
        "the group {} was asked for, but these readings determine no parameter of it within what a joint that works "
        "can have ({}). Leave it out of the model",
        name_of(group), reasons));
  }

  const Recording& recording_;
  const Constraints& constraints_;
  const IdentifyOptions& options_;
  const WeakPrior& prior_;
  Arm nominal_;
  Preparation preparation_;
  std::vector<FixedMember> fixed_;
};

}  // namespace

Expected<GroupFit> fix_undetermined_members(Expected<ArmFit> first, const Recording& recording,
                                            const Constraints& constraints, Preparation preparation,
                                            const IdentifyOptions& options, const WeakPrior& prior) {
  return Fitting(recording, constraints, std::move(preparation), options, prior).after(std::move(first));
}

bool keeps_all_members(const Recording& recording, const std::vector<Parameter>& free, const IdentifyOptions& options,
                       const Arm& arm, const Eigen::MatrixXd& covariance) {
  return !worst_of(members_in(free, arm_for(options.model, recording.arm), options), free, arm, covariance);
}

}  // namespace artcal
