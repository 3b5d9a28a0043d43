#include "identification/initial/initial_alignment.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "identification/identifiability/coupling.h"
#include "identification/identifiability/weak_parameters.h"
#include "identification/initial/coarse_fit.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/problem.h"
#include "identification/least_squares/residual.h"
#include "identification/problem/tips.h"

namespace artcal {
namespace {

// Below this share of ball's and tip's radius the readings are surely on the side of the ball where the arm has them.
constexpr double round_enough = 0.03;
constexpr double near_enough = 0.01;  // mm; the identification that follows takes it from there
constexpr int iterations = 30;
constexpr double firmly = 1e4;  // times a prior's weight: what it is on stays
// What counts as far from a sphere, mm, round by round: a wide loss finds the way, a narrow one lets go of balls on the
// wrong side.
constexpr double narrowing[] = {3.0, 3.0, 1.0, 1.0, 0.3, 0.3, 0.3};

bool is_ball(const FeatureConstraint& feature) { return feature.is<OnBall>(); }

double rms_of(const Tips& tips, const Unknowns& unknowns) {
  const FeatureConstraint& feature = *tips.feature;
  const GroupState& group = state_of(feature, unknowns);
  const FeatureResidual residual(feature, group.reference, group.values.data(), unknowns.shared.data());
  double squares = 0.0;
  for (int k = 0; k < feature.size(); ++k) {
    const Residual r = residual.at(k, tips.centres.col(k), tips.radii[k], false);
    squares += r.value.head(r.rows).squaredNorm();
  }
  return std::sqrt(squares / feature.size());
}

bool all_round(const std::vector<Tips>& tips, const Unknowns& unknowns) {
  return std::all_of(tips.begin(), tips.end(), [&](const Tips& own) {
    const auto* ball = own.feature->as<OnBall>();
    return ball == nullptr || rms_of(own, unknowns) < round_enough * (ball->radius.value_or(0.0) + own.radii[0]);
  });
}

// The parameters of the selection that these constraints determine at this arm.
std::vector<Parameter> identifiable(const Recording& recording, const Constraints& constraints, const Arm& arm,
                                    const Selection& selection) {
  const auto coupling = analyse_coupling(recording, constraints, arm, coupling_options(selection));
  const auto free = coupling ? free_parameters(selection, *coupling) : tl::unexpected(coupling.error());
  return free ? *free : std::vector<Parameter>{};
}

/// A fit on its way: where it is, what it may move, and the prior on that.
struct State {
  System system;
  Eigen::VectorXd x;
  Unknowns unknowns;
  Eigen::VectorXd prior;

  [[nodiscard]] Arm arm() const { return system.arm_at(x.data()); }
};

// One fit from where the state is; false where the numbers break down.
bool fit(State& state, double sigma, Loss loss) {
  SolveOptions options{loss, iterations, near_enough, state.prior};
  options.folding = Folding::NormalEquations;
  options.linearise_solution = false;
  Solution solution =
      solve(state.system, coarse_weights(*state.system.constraints, sigma), state.x, state.unknowns, options);
  if (solution.termination == Termination::Failed || !solution.x.allFinite()) {
    return false;
  }
  state.x = std::move(solution.x);
  state.unknowns = std::move(solution.unknowns);
  return true;
}

// The arm fitted to the centres as points, the tip fixed.
std::optional<State> fit_to_centres(Alignment alignment, const Recording& recording, const Constraints& constraints,
                                    const Constraints& points, const Arm& start, const Selection& selection) {
  auto free = identifiable(recording, points, start, selection);
  std::erase_if(free, [](const Parameter& parameter) { return parameter.is_tip(); });
  State state{make_system(recording, points, start, std::move(free)), {}, {}, {}};
  if (alignment != Alignment::TipCentres) {
    lengthen_to_centres(constraints, state.system);
  }
  auto unknowns = estimate_nuisance_parameters(state.system, state.system.start, recording);
  if (!unknowns) {
    return std::nullopt;
  }
  state.unknowns = std::move(*unknowns);
  state.x = Eigen::VectorXd::Zero(state.system.arm_size());
  state.prior = prior_weights(state.system);
  const double sigma = centre_deviation(constraints, start);
  if (alignment == Alignment::JointsFirst) {
    State offsets = state;
    for (int i = 0; i < state.system.arm_size(); ++i) {
      offsets.prior[i] *= state.system.free[i].kind == ParameterKind::Theta ? 1.0 : firmly;
    }
    if (fit(offsets, sigma, Loss::None)) {
      state.x = offsets.x;
      state.unknowns = std::move(offsets.unknowns);
    }
  }
  // The second lets go of readings that carry another feature's name.
  const bool done = fit(state, sigma, Loss::None) && fit(state, sigma, Loss::Cauchy);
  return done ? std::optional(std::move(state)) : std::nullopt;
}

// Where the fit to the spheres begins: at the centres, planes and poses of the coarse fit, radii by the readings.
std::optional<Unknowns> begin_at(const Unknowns& coarse, const System& system, const Arm& arm,
                                 const Recording& recording) {
  auto unknowns = estimate_nuisance_parameters(system, arm, recording);
  if (!unknowns) {
    return std::nullopt;
  }
  for (std::size_t g = 0; g < unknowns->groups.size() && unknowns->groups.size() == coarse.groups.size(); ++g) {
    if (unknowns->groups[g].values.size() == coarse.groups[g].values.size()) {
      unknowns->groups[g] = coarse.groups[g];
    }
  }
  return std::move(*unknowns);
}

// All parameters free, with a loss that narrows until every ball is round.
std::optional<Arm> fit_to_spheres(const Recording& recording, const Constraints& constraints, const Arm& start,
                                  const Arm& coarse, const Unknowns* centres, const Selection& selection) {
  State state{
      make_system(recording, constraints, start, identifiable(recording, constraints, coarse, selection)), {}, {}, {}};
  state.x.resize(state.system.arm_size());
  for (int i = 0; i < state.system.arm_size(); ++i) {
    const Parameter& parameter = state.system.free[i];
    state.x[i] = (value(coarse, parameter) - value(start, parameter)) / state.system.scale[i];
  }
  auto unknowns = centres != nullptr ? begin_at(*centres, state.system, state.arm(), recording) : std::nullopt;
  state.prior = prior_weights(state.system);
  for (const double sigma : narrowing) {
    if (!unknowns) {
      const auto estimated = estimate_nuisance_parameters(state.system, state.arm(), recording);
      unknowns = estimated ? std::optional(*estimated) : std::nullopt;
    }
    if (!unknowns) {
      return std::nullopt;
    }
    state.unknowns = std::move(*unknowns);
    unknowns.reset();
    if (!fit(state, sigma, Loss::Cauchy)) {
      return std::nullopt;
    }
    if (all_round(all_tips(state.system, state.arm()), state.unknowns)) {
      break;
    }
  }
  return state.arm();
}

}  // namespace

std::vector<Alignment> alignments_for(const Recording& recording, const Constraints& constraints, const Arm& arm) {
  using enum Alignment;
  const bool has_balls = std::any_of(constraints.features.begin(), constraints.features.end(), is_ball);
  if (constraints.features.empty()) {
    return {None};
  }
  if (!has_balls) {
    return std::vector{None, TipCentres, JointsFirst};
  }
  const System system = make_system(recording, constraints, arm, {});
  const auto tips = all_tips(system, arm);
  const auto unknowns = estimate_nuisance_parameters(system, arm, recording, tips);
  return unknowns && all_round(tips, *unknowns) ? std::vector{None, StylusCentres, TipCentres, Robust, JointsFirst}
                                                : std::vector{StylusCentres, TipCentres, Robust, JointsFirst, None};
}

std::optional<Arm> align(Alignment alignment, const Recording& recording, const Constraints& constraints,
                         const Arm& start, const Selection& selection) {
  if (alignment == Alignment::None) {
    return start;
  }
  if (alignment == Alignment::Robust) {
    return fit_to_spheres(recording, constraints, start, start, nullptr, selection);
  }
  const Constraints points = balls_as_points(constraints);
  const auto state = fit_to_centres(alignment, recording, constraints, points, start, selection);
  if (!state) {
    return std::nullopt;
  }
  Arm coarse = state->arm();
  coarse.probes = start.probes;
  return fit_to_spheres(recording, constraints, start, coarse, &state->unknowns, selection);
}

}  // namespace artcal
