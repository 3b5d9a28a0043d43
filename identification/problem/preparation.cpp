#include "identification/problem/preparation.h"

#include <algorithm>

#include <fmt/format.h>

#include "acquisition/recording/tip_centres.h"
#include "identification/identifiability/coupling.h"
#include "identification/identifiability/selection.h"
#include "identification/problem/start.h"

namespace artcal {
namespace {

Error scale_is_unidentifiable() {
  return {
      ErrorCode::NoSolution,
      "no calibrated length is in these readings, so the scale of the arm is not identifiable: all lengths could grow "
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

// The parameters free at `start`, which differs from `nominal` by what an alignment or an identification found.
Expected<Preparation> prepared_at(const Arm& start, const Arm& nominal, const Recording& recording,
                                  const Constraints& constraints, const Selection& selection, const Noise& noise) {
  CouplingOptions coupling_request = coupling_options(selection);
  coupling_request.noise = noise;
  auto coupling = analyse_coupling(recording, constraints, start, coupling_request);
  if (!coupling) {
    // An alignment that led to an arm of no size, say, is no fault of the arm's file.
    const bool is_of_file = coupling.error().code != ErrorCode::BadInput ||
                            !analyse_coupling(recording, constraints, nominal, coupling_request);
    return is_of_file ? tl::unexpected(coupling.error())
                      : no_convergence("the initial alignment did not converge to an arm");
  }
  if (coupling->scale == ScaleState::Unidentifiable) {
    return tl::unexpected(scale_is_unidentifiable());
  }
  auto free = free_parameters(selection, *coupling);
  if (!free) {
    return tl::unexpected(free.error());
  }
  if (free->empty()) {
    return no_solution("nothing is left to identify: every parameter is fixed or unidentifiable");
  }
  Preparation preparation{nominal, std::move(*coupling), std::move(*free)};
  // Fixed parameters stay nominal, fitted tip or not.
  for (const Parameter& parameter : preparation.free) {
    set_value(preparation.start, parameter, value(start, parameter));
  }
  return preparation;
}

}  // namespace

Expected<Preparation> prepare(const Recording& recording, const Constraints& constraints,
                              const IdentifyOptions& options, Alignment alignment, const Arm* from) {
  if (auto sensible = check_model(recording, options); !sensible) {
    return tl::unexpected(sensible.error());
  }
  const Arm nominal = arm_for(options.model, recording.arm);
  const auto selection = select_parameters(nominal, options.hold, options.free, options.model);
  if (!selection) {
    return tl::unexpected(selection.error());
  }
  const auto aligned =
      align(alignment, recording, constraints, from != nullptr ? *from : nominal, of_chain(*selection));
  if (!aligned) {
    return no_convergence("the initial alignment did not converge to an arm");
  }
  const auto start = arm_with_fitted_tips(recording, constraints, *aligned, options.hold);
  if (!start) {
    return tl::unexpected(start.error());
  }
  return prepared_at(*start, nominal, recording, constraints, *selection, options.noise);
}

Expected<Preparation> prepare_from(const Arm& start, const Recording& recording, const Constraints& constraints,
                                   const IdentifyOptions& options) {
  if (auto sensible = check_model(recording, options); !sensible) {
    return tl::unexpected(sensible.error());
  }
  const Arm nominal = arm_for(options.model, recording.arm);
  const auto selection = select_parameters(nominal, options.hold, options.free, options.model);
  if (!selection) {
    return tl::unexpected(selection.error());
  }
  return prepared_at(start, nominal, recording, constraints, *selection, options.noise);
}

}  // namespace artcal
