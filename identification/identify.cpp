#include "identification/identify.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "acquisition/joint_error_keys.h"
#include "acquisition/tip_centres.h"
#include "core/statistics.h"
#include "core/units.h"
#include "identification/arm_fit.h"
#include "identification/common_errors.h"
#include "identification/coupling_analysis.h"
#include "identification/leave_out.h"
#include "identification/lost_text.h"
#include "identification/near_the_balls.h"
#include "identification/outliers.h"
#include "identification/residual_search.h"
#include "identification/selection.h"
#include "identification/start.h"
#include "identification/strange.h"

namespace artcal {
namespace {

// What stands out by more, mm, is worth a warning; by more than the second it is no reading of what it is said to be.
constexpr double a_slip = 0.3;
constexpr double another_place = 2.0;

/// What is settled before anything is solved.
struct Preparation {
  Arm start;
  Coupling coupling;
  std::vector<Parameter> free;
  std::optional<Linearisation> at_start;  ///< by the free parameters, where it is known already

  [[nodiscard]] const Linearisation* known_start() const { return at_start ? &*at_start : nullptr; }
};

Error scale_is_lost() {
  return {
      ErrorCode::NoSolution,
      "no calibrated length is in these readings, so the scale of the arm cannot be told: all lengths could grow "
      "together and every reading would still fit. Measure a certified length as well: a ball bar or a bar with two "
      "seats or parallel faces (at least one distance with its U), balls of known diameter, or points of known "
      "coordinates",
      {}};
}

// Whether the model makes sense here, and the readings have what it needs.
Expected<void> check_model(const Recording& recording, const IdentifyOptions& options) {
  for (const ParameterGroup group : options.model) {
    if (const std::string obstacle = obstacle_to(group, recording.arm, recording); !obstacle.empty()) {
      return wrong_usage(fmt::format("the model has the group {}, but {}", name_of(group), obstacle));
    }
  }
  const auto all = all_parameters(recording.arm);
  const bool frees_expansion = std::any_of(all.begin(), all.end(), [&](const Parameter& parameter) {
    return parameter.kind == ParameterKind::Expansion &&
           std::find(options.free.begin(), options.free.end(), parameter.name) != options.free.end();
  });
  return expands(recording.arm) || frees_expansion ? require_arm_temperatures(recording) : Expected<void>{};
}

Expected<Preparation> prepare(const Recording& recording, const Constraints& constraints,
                              const IdentifyOptions& options) {
  const Arm nominal = arm_for(options.model, recording.arm);
  const auto selection = select_parameters(nominal, options.hold, options.free, options.model);
  if (!selection) {
    return tl::unexpected(selection.error());
  }
  const auto start = arm_with_fitted_tips(recording, constraints, nominal, options.hold).map([&](const Arm& with_tips) {
    return arm_near_the_balls(recording, constraints, with_tips, of_chain(*selection));
  });
  if (!start) {
    return tl::unexpected(start.error());
  }
  CouplingOptions coupling_request = coupling_options(*selection);
  coupling_request.noise = options.noise;
  auto analysis = analyse(recording, constraints, *start, coupling_request);
  if (!analysis) {
    return tl::unexpected(analysis.error());
  }
  if (analysis->coupling.scale == ScaleState::Lost) {
    return tl::unexpected(scale_is_lost());
  }
  auto free = free_parameters(*selection, analysis->coupling);
  if (!free) {
    return tl::unexpected(free.error());
  }
  if (free->empty()) {
    return no_solution("nothing is left to identify: every parameter is held or lost");
  }
  Preparation preparation{nominal, std::move(analysis->coupling), std::move(*free), {}};
  const auto& asked = preparation.coupling.parameters;
  std::vector<int> kept;
  // Held parameters stay nominal, fitted tip or not.
  for (const Parameter& parameter : preparation.free) {
    set_value(preparation.start, parameter, value(*start, parameter));
    kept.push_back(find_parameter(asked, parameter.name));
  }
  const bool starts_there = std::all_of(asked.begin(), asked.end(), [&](const Parameter& parameter) {
    return value(preparation.start, parameter) == value(*start, parameter);
  });
  if (analysis->as_read && starts_there) {
    preparation.at_start = with_parameters(*analysis->as_read, static_cast<int>(asked.size()), kept);
  }
  return preparation;
}

std::vector<IdentifiedParameter> describe(const Arm& nominal, const Arm& identified, const Preparation& preparation,
                                          const Eigen::MatrixXd& covariance) {
  std::vector<IdentifiedParameter> all;
  const auto is_lost = [&](const std::string& name) {
    return std::any_of(
        preparation.coupling.lost.begin(), preparation.coupling.lost.end(),
        [&](const ParameterMotion& motion) { return preparation.coupling.parameters[motion.leading].name == name; });
  };
  const auto pairs = wrist_pairs(nominal);
  const auto in_pair = [&](const std::string& name) {
    return std::any_of(pairs.begin(), pairs.end(),
                       [&](const WristPair& pair) { return pair.first == name || pair.second == name; });
  };
  for (const Parameter& parameter : all_parameters(nominal)) {
    const int free = find_parameter(preparation.free, parameter.name);
    const bool is_asked = find_parameter(preparation.coupling.parameters, parameter.name) >= 0;
    if (!is_asked &&
        (parameter.kind == ParameterKind::Radius || (parameter.is_joint_error() && value(nominal, parameter) == 0.0))) {
      continue;  // known, and no part of this
    }
    const ParameterState state = free >= 0                                             ? ParameterState::Identified
                                 : is_lost(parameter.name) && !in_pair(parameter.name) ? ParameterState::Lost
                                                                                       : ParameterState::Held;
    all.push_back({parameter, value(nominal, parameter), value(identified, parameter),
                   free >= 0 ? std::sqrt(covariance(free, free)) : 0.0, state});
  }
  return all;
}

std::vector<ArtefactValue> describe_artefacts(const Constraints& constraints, const ArmFit& fit, double enlargement) {
  const auto variances = shared_variances(fit.linearisation, static_cast<int>(fit.scale.size()));
  std::vector<ArtefactValue> values;
  for (std::size_t s = 0; s < constraints.shared.size() && variances; ++s) {
    const SharedUnknown& shared = constraints.shared[s];
    const Artefact& artefact = constraints.artefacts[shared.artefact];
    const CertifiedFeature& feature = artefact.features[shared.feature];
    const auto i = static_cast<Eigen::Index>(s);
    const bool radius = shared.quantity == SharedUnknown::Quantity::Radius;
    const double from = radius ? 0.0 : (*feature.at)[static_cast<Eigen::Index>(shared.quantity)];
    values.push_back({artefact.name, feature.name, shared.quantity,
                      shared.u > 0.0 ? std::optional(from + shared.certified) : std::nullopt, shared.u,
                      from + fit.unknowns.shared[i], enlargement * std::sqrt((*variances)[i])});
  }
  return values;
}

// Things that are no error but that a careful person would want to know.
std::vector<std::string> suspicions(const Identification& result, double length) {
  std::vector<std::string> warnings;
  for (const auto& parameter : result.parameters) {
    const double moved = std::abs(parameter.identified - parameter.nominal);
    if (parameter.parameter.is_angle() && moved > 5.0 * units::degree) {
      warnings.push_back(
          fmt::format("{} moved by {:.3g} deg from its nominal value: are joint order, signs and units "
                      "right?",
                      parameter.parameter.name, moved / units::degree));
    } else if (parameter.parameter.is_length() && moved > 0.05 * length) {
      warnings.push_back(fmt::format("{} moved by {:.4g} mm from its nominal value: is this the arm that was read?",
                                     parameter.parameter.name, moved));
    }
  }
  if (!result.noise_is_given && result.noise < 1e-6) {
    warnings.push_back(
        "the readings agree to the last digits, as no real ones do: the standard uncertainties say nothing about a "
        "real arm");
  }
  if (const auto strange = what_stands_out(result.after, a_slip)) {
    warnings.push_back(*strange);
  }
  if (result.after.overall.rms > result.before.overall.rms) {
    warnings.push_back("the identified arm fits the readings no better than the nominal one");
  }
  double squares = 0.0;
  int count = 0;
  for (const auto& left : result.left_out) {
    squares += left.deviation.readings * left.deviation.rms * left.deviation.rms;
    count += left.deviation.readings;
  }
  if (count > 0 && std::sqrt(squares / count) > 1.5 * result.after.overall.rms) {
    warnings.push_back(
        fmt::format("placements that were left out fit {:.1f} times worse than those identified from: "
                    "the readings are few, or too much alike, for so many parameters",
                    std::sqrt(squares / count) / result.after.overall.rms));
  }
  return warnings;
}

// What was wrong with a fit that failed, where the arm that it began with shows it.
Error with_reason(Error error, const Recording& recording, const Constraints& constraints, const Arm& start) {
  const auto evaluation = evaluate(recording, constraints, start);
  if (const auto strange = evaluation ? what_stands_out(*evaluation, another_place) : std::nullopt) {
    error.message = *strange + " No arm was found that fits all (" + error.message + ")";
  }
  return error;
}

// Joint errors that no joint has: readings that hardly tell them let them run away.
Expected<void> check_joint_errors(const std::vector<IdentifiedParameter>& parameters) {
  std::string absurd, names;
  for (const IdentifiedParameter& p : parameters) {
    if (p.state == ParameterState::Identified && p.parameter.is_joint_error() &&
        !(std::abs(p.identified) <= most_of(p.parameter.kind))) {
      absurd += fmt::format("{}{} = {:.3g} with a standard uncertainty of {:.2g}", absurd.empty() ? "" : ", ",
                            p.parameter.name, p.identified, p.u);
      names += (names.empty() ? "" : ",") + p.parameter.name;
    }
  }
  if (absurd.empty()) {
    return {};
  }
  return no_solution(
      fmt::format("no joint that works has such errors: {} (rad, rad/rad, rad/(N mm), 1/K); these "
                  "readings hardly tell them. Leave the group out of the model, or hold them: --hold {}",
                  absurd, names));
}

void judge_noise(const ArmFit& fit, Identification& result) {
  result.noise = fit.noise;
  result.degrees_of_freedom = fit.degrees_of_freedom;
  result.chi_squared = fit.residuals.readings_squared() + fit.residuals.certificates_squared();
  result.chi_squared_low = chi_squared_quantile(0.025, fit.degrees_of_freedom);
  result.chi_squared_high = chi_squared_quantile(0.975, fit.degrees_of_freedom);
  if (!result.noise_is_given) {
    return;
  }
  if (result.chi_squared > result.chi_squared_high) {
    result.enlargement = std::sqrt(result.chi_squared / fit.degrees_of_freedom);
    result.warnings.push_back(
        fmt::format("the residuals are {:.2f} times the stated noise, more than chance allows: "
                    "the noise is larger, or the arm has errors this model does not know; all "
                    "standard uncertainties were enlarged by that factor",
                    result.enlargement));
  } else if (result.chi_squared < result.chi_squared_low) {
    result.warnings.push_back(
        fmt::format("the residuals are only {:.2f} times the stated noise: the noise is stated "
                    "too large, and so are the standard uncertainties",
                    std::sqrt(result.chi_squared / fit.degrees_of_freedom)));
  }
}

}  // namespace

Expected<Identification> identify(const Recording& recording, const Constraints& constraints,
                                  const IdentifyOptions& options) {
  if (auto there = require_joints(recording); !there) {
    return tl::unexpected(there.error());
  }
  if (auto sensible = check_model(recording, options); !sensible) {
    return tl::unexpected(sensible.error());
  }
  auto preparation = prepare(recording, constraints, options);
  if (!preparation) {
    return tl::unexpected(preparation.error());
  }
  const SolveOptions solve_options{options.loss, options.max_iterations};
  const auto fit = fit_arm(recording, constraints, preparation->start, preparation->free, options.noise, solve_options);
  if (!fit) {
    return tl::unexpected(with_reason(fit.error(), recording, constraints, preparation->start));
  }
  const auto covariance = arm_covariance(fit->scale, fit->linearisation);
  if (!covariance) {
    return no_solution(
        "the readings determine the parameters at the nominal arm but not at the identified one; hold "
        "the parameters that the coupling analysis calls weak");
  }
  const System identified = make_system(recording, constraints, fit->arm, preparation->free);
  const auto common = common_errors(identified, *fit, recording);
  if (!common) {
    return tl::unexpected(common.error());
  }
  const auto before = evaluate(recording, constraints, recording.arm);
  const auto after = evaluate(recording, constraints, fit->arm);
  for (const auto* judged : {&before, &after}) {
    if (!*judged) {
      return tl::unexpected(judged->error());
    }
  }
  // One feature in another's place spoils the arm, unless a loss let go of it.
  if (const auto strange = what_stands_out(*after, another_place); strange && options.loss == Loss::None) {
    return no_solution(*strange +
                       " No arm fits all of them. Correct or take out what is wrong; --loss cauchy lets go of single "
                       "readings and lists them");
  }
  Identification result;
  result.arm = fit->arm;
  result.model = options.model;
  result.noise_is_given = options.noise.is_given();
  judge_noise(*fit, result);
  result.covariance = result.enlargement * result.enlargement * (*covariance + *common);
  result.parameters = describe(arm_for(options.model, recording.arm), fit->arm, *preparation, result.covariance);
  for (const Parameter& parameter : preparation->free) {
    const auto found = std::find_if(result.parameters.begin(), result.parameters.end(),
                                    [&](const auto& described) { return described.parameter.name == parameter.name; });
    result.free.push_back(static_cast<int>(found - result.parameters.begin()));
  }
  if (auto sensible = check_joint_errors(result.parameters); !sensible) {
    return tl::unexpected(sensible.error());
  }
  result.artefact_values = describe_artefacts(constraints, *fit, result.enlargement);
  result.before = *before;
  result.after = *after;
  result.outliers = find_outliers(recording, constraints, fit->residuals, result.after);
  result.model_study = search_residuals(identified, *fit, recording);
  if (auto warning = warning_of(result.model_study); !warning.empty()) {
    result.warnings.push_back(std::move(warning));
  }
  result.iterations = fit->iterations;
  result.noise_rounds = fit->rounds;
  result.cost = fit->cost;
  result.termination = fit->termination;
  if (options.leave_out) {
    IdentifyOptions again = options;
    if (!options.noise.is_given()) {
      again.noise.reading = fit->noise;
    }
    const auto identify_without = [&](const Constraints& rest) -> Expected<Arm> {
      const auto prepared = prepare(recording, rest, again);
      if (!prepared) {
        return tl::unexpected(prepared.error());
      }
      return fit_arm(recording, rest, prepared->start, prepared->free, again.noise, solve_options,
                     prepared->known_start())
          .map([](const ArmFit& refit) { return refit.arm; });
    };
    result.left_out = leave_placements_out(recording, constraints, identify_without, options.threads);
  }
  result.coupling = std::move(preparation->coupling);
  const auto more = suspicions(result, reach(recording.arm));
  result.warnings.insert(result.warnings.end(), more.begin(), more.end());
  return result;
}

}  // namespace artcal
