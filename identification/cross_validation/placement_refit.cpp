#include "identification/cross_validation/placement_refit.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "identification/initial/constraint_projection.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/monte_carlo/gradient.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

// What is left of the way, judged by how fast steps shrink, in standard deviations.
constexpr double close_enough = 1e-7;
// A shorter step changes weights that depend on the posture by less than 1e-9 of them.
constexpr double moves_weights = 1e-2;
constexpr int max_steps = 12;
// A step is to be shorter than this share of the one before it.
constexpr double converges = 0.5;
// σ/σ1 below which only the analysis of a whole identification can determine a weak direction from a lost one: half the
// digits are gone with the normal matrix.
constexpr double surely_determined = 1e-5;
constexpr int passes_of_a_column = 3;

// An exact gradient takes a pass over all readings, of which each placement needs two; the expansion takes two for each
// of its columns and as much again for their products.
bool is_worth_expanding(const System& system, const std::vector<std::optional<Placement>>& places) {
  std::set<Placement> placements;
  for (const auto& place : places) {
    if (place) {
      placements.insert(*place);
    }
  }
  return static_cast<int>(placements.size()) > passes_of_a_column * (system.shared_size() + system.arm_size());
}

PlacedLinearisation placed_linearisation(const System& system, const Weights& weights, const std::vector<Block>& blocks,
                                         const std::vector<std::optional<Placement>>& places, const Arm& arm,
                                         const Unknowns& unknowns) {
  return {linearise(system, weights, Loss::None, blocks, arm, unknowns), places};
}

}  // namespace

Expected<PlacementRefit> PlacementRefit::of(const System& system, const ArmFit& fit, const Recording& recording,
                                            const Noise& noise, int threads, std::optional<bool> expand) {
  const Constraints& constraints = *system.constraints;
  PlacementRefit refit;
  refit.system_ = &system;
  refit.fit_ = &fit;
  refit.noise_ = noise;
  refit.weights_ = first_weights(system, fit.arm, fit.unknowns, noise);
  refit.blocks_ = placed_blocks(constraints, refit.places_);
  refit.layout_ = layout_of(constraints, system.arm_size());
  refit.start_ = packed(refit.layout_, fit.unknowns, Eigen::VectorXd::Zero(system.arm_size()));
  refit.at_fit_ = std::make_shared<const Trees>(
      placed_linearisation(system, refit.weights_, refit.blocks_, refit.places_, fit.arm, fit.unknowns));
  refit.gradient_ = gradient(refit.at_fit_->linearisation.linearisation);
  const bool moves = std::any_of(constraints.features.begin(), constraints.features.end(),
                                 [&](const FeatureConstraint& feature) { return needs_moving(feature, constraints); });
  if (moves) {
    System moved = system;
    auto unknowns = estimate_nuisance_parameters(system, fit.arm, recording);
    if (!unknowns) {
      return tl::unexpected(unknowns.error());
    }
    satisfy_distances(constraints, *unknowns);
    project_onto_constraints(moved, recording, fit.arm, *unknowns);
    refit.consistent_ = std::make_shared<const Trees>(
        placed_linearisation(moved, refit.weights_, refit.blocks_, refit.places_, fit.arm, *unknowns));
  } else {
    refit.consistent_ = refit.at_fit_;
  }
  if (expand.value_or(is_worth_expanding(system, refit.places_))) {
    refit.expansion_ = GradientExpansion::of(system, fit, noise, refit.weights_, refit.blocks_, refit.places_, threads);
  }
  return refit;
}

// As fit_arm() counts them, of the other placements.
int PlacementRefit::degrees_of_freedom(const Placement& placement) const {
  const Constraints& constraints = *system_->constraints;
  int freedom = constraints.residual_count() - constraints.unknown_count() - system_->arm_size();
  std::vector<bool> counted(constraints.groups.size(), false);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!places_[b] || *places_[b] != placement) {
      continue;
    }
    for (const int f : blocks_[b].features) {
      freedom -= constraints.features[f].size() * constraints.features[f].dimension();
    }
    freedom -= static_cast<int>(blocks_[b].distances.size());
    if (blocks_[b].group >= 0 && !counted[blocks_[b].group]) {
      counted[blocks_[b].group] = true;
      freedom += blocks_[b].unknowns;
    }
  }
  return freedom;
}

Unknowns PlacementRefit::unknowns_at(const Eigen::VectorXd& numbers) const {
  Unknowns unknowns = fit_->unknowns;
  unpack(layout_, numbers, unknowns);
  return unknowns;
}

// The residuals of the other placements are at most those of all at the solution for all.
PlacementRefit::Refit PlacementRefit::refit_of(Arm arm, const GramTree::Without& factor, int degrees_of_freedom) const {
  const double squares = fit_->residuals.readings_squared() + fit_->residuals.certificates_squared();
  const auto scale = system_->scale.asDiagonal();
  Eigen::MatrixXd covariance = scale * factor.arm_covariance() * scale;
  Eigen::MatrixXd bound = std::max(1.0, squares / degrees_of_freedom) * covariance;
  return {std::move(arm), std::move(covariance), std::move(bound), false};
}

std::optional<PlacementRefit::Refit> PlacementRefit::without(const Placement& placement) const {
  const int freedom = degrees_of_freedom(placement);
  if (freedom < 1) {
    return std::nullopt;
  }
  const auto factor = at_fit_->tree.without(placement);
  if (!factor) {
    return std::nullopt;
  }
  const auto rank = consistent_ == at_fit_ ? factor : consistent_->tree.without(placement);
  if (!rank || !(rank->condition() > surely_determined)) {
    return std::nullopt;
  }
  if (expansion_) {
    if (const auto minimum = expansion_->without(placement); minimum && minimum->left < close_enough) {
      Refit refit = refit_of(system_->arm_at(minimum->x.data()), *factor, freedom);
      refit.expanded = true;
      return refit;
    }
  }
  GradientScratch scratch = gradient_scratch(*system_);
  scratch.blocks.clear();
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!places_[b] || *places_[b] != placement) {
      scratch.blocks.push_back(blocks_[b]);
    }
  }
  Eigen::VectorXd numbers = start_;
  Eigen::VectorXd slope = gradient_ - at_fit_->tree.gradient_of(placement);
  Weights weights = weights_;
  double last = 0.0;  // length of the last step
  double shrinking = 1.0;
  for (int steps = 1; steps <= max_steps; ++steps) {
    const ArrowFactor::Step step = factor->solve(slope);
    if (!step.numbers.allFinite()) {
      return std::nullopt;
    }
    numbers -= step.numbers;
    if (last > 0.0) {
      shrinking = std::min(shrinking, step.length / last);
    }
    const Arm arm = system_->arm_at(numbers.data() + layout_.arm);
    if (step.length * shrinking < close_enough) {
      return refit_of(arm, *factor, freedom);
    }
    if (last > 0.0 && step.length > converges * last) {
      return std::nullopt;
    }
    last = step.length;
    if (noise_.encoder && step.length > moves_weights) {
      weights = posture_weights(*system_, arm, unknowns_at(numbers), *noise_.encoder, *noise_.probing);
    }
    slope = gradient(*system_, weights, Loss::None, layout_, fit_->unknowns, numbers, scratch);
  }
  return std::nullopt;
}

}  // namespace artcal
