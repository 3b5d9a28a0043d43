#pragma once

#include <optional>
#include <string>
#include <vector>

#include "artefacts/constraints/constraint.h"
#include "artefacts/simulation/simulate.h"
#include "core/error.h"
#include "identification/identifiability/coupling.h"
#include "identification/identifiability/observability.h"
#include "identification/planning/goal.h"

namespace artcal {

struct PlanningOptions {
  int placements = 4;  ///< to choose
  int readings = 10;   ///< of each feature in a chosen placement
  Goal goal = Goal::Worst;
  Noise noise;     ///< stated; what readings are worth
  int starts = 3;  ///< of the exchange
  int test_lengths = 200;
  int random_plans = 20;      ///< drawn to compare with
  int random_placements = 0;  ///< in each of them; 0: as many as are chosen
  std::uint64_t seed = 1;
};

/// A ball as a plan has it touched.
struct PlannedBall {
  std::string feature;
  int touches = 0;
  double dilution = 0.0;  ///< of its centre (artefacts/simulation/pattern.h); infinite: they do not determine the ball
};

/// A placement that was chosen, and the readings to take there.
struct ChosenPlacement {
  int candidate = 0;          ///< into Simulation::placements
  std::vector<int> readings;  ///< into Simulation::recording
  std::vector<PlannedBall> balls;
};

/// What a set of readings is expected to give.
struct Expectation {
  PredictedU u;                 ///< of lengths that the choice was not made by
  PredictedU u_of_arm;          ///< without the noise of the readings of the length itself
  Observability observability;  ///< of the free parameters, whitened by the noise: 1 is what one reading tells of 1 mm
};

struct Planning {
  Coupling coupling;            ///< what all possible readings together tell
  std::vector<Parameter> free;  ///< what can be identified
  std::vector<ChosenPlacement> chosen;
  std::optional<Expectation> measured;  ///< by what was measured already
  Expectation planned;                  ///< with the choice
  Expectation all;                      ///< with everything that is possible, more than could be chosen
  PredictedU random;                    ///< medians over as many placements and readings drawn by chance
  PredictedU random_of_arm;             ///< as Expectation::u_of_arm
};

/// The placements and readings of `possible` (taken without noise by the arm that is to be calibrated) to take next, so
/// that the standard uncertainty of lengths in its volume, as the identified arm will measure them, becomes small.
/// Placements are exchanged first, each with all its possible readings at the weight of as many as will be
/// taken; then the readings of each (DETMAX, Mitchell 1974; observability indices, Gao 2013). Lengths are drawn between
/// the end stops; those that the result is told by are others than those that the choice was made by. Touches of a ball
/// that lie on a small part of it are exchanged for others (max_planned_dilution).
/// `measured`, with its constraints, is what counts anyway.
///
/// Refused: fewer possible placements than are asked for, a noise that is not stated. No solution: readings that tell
/// no length.
Expected<Planning> plan_session(const Simulation& possible, const Constraints& constraints, const Recording* measured,
                                const Constraints* measured_constraints, const PlanningOptions& options);

}  // namespace artcal
