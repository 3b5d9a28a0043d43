#include "identification/initial/nuisance_estimation.h"

#include <optional>

#include <fmt/format.h>
#include <Eigen/QR>

#include "identification/initial/ball_start.h"
#include "identification/initial/plane_start.h"
#include "identification/initial/pose_start.h"
#include "identification/least_squares/problem.h"
#include "identification/least_squares/rows.h"
#include "identification/problem/tips.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

// Against readings that count 1 per mm: what is certified stays where it is.
constexpr double fixed_firmly = 1e6;

std::string called(const FeatureConstraint& feature, const Constraints& constraints, const Recording& recording) {
  const FeatureName name = name_of(feature, constraints, recording);
  return fmt::format("feature \"{}\" of artefact \"{}\" in placement \"{}\"", name.feature, name.artefact,
                     name.placement);
}

// Radii that no certificate tells: each ball's from its own readings, then their mean over the placements.
void estimate_radii(const std::vector<Tips>& balls, const Constraints& constraints, Eigen::VectorXd& shared) {
  for (Eigen::Index s = 0; s < shared.size(); ++s) {
    shared[s] = constraints.shared[s].certified;
    double sum = 0.0;
    int count = 0;
    for (const Tips& tips : balls) {
      if (tips.feature->shared_radius() != s || constraints.shared[s].u > 0.0) {
        continue;
      }
      if (const auto ball = ball_touched_at(tips.centres, tips.radii)) {
        sum += tips.feature->size() * ball->radius / tips.feature->expansion;
        count += tips.feature->size();
      }
    }
    shared[s] = count > 0 ? sum / count : shared[s];
  }
}

// Radii and what hangs on them together, with the arm and what is certified held.
void refine_radii(System system, const Arm& arm, Unknowns& unknowns) {
  const Constraints& constraints = *system.constraints;
  system.start = arm;
  system.free.clear();
  system.scale.resize(0);
  Weights weights = unit_weights(constraints);
  weights.distances.assign(constraints.distances.size(), 0.0);
  bool uncertified = false;
  for (std::size_t s = 0; s < constraints.shared.size(); ++s) {
    uncertified |= constraints.shared[s].u == 0.0;
    weights.shared[s] = constraints.shared[s].u > 0.0 ? fixed_firmly : 0.0;
  }
  if (uncertified) {
    SolveOptions options;
    options.linearise_solution = false;
    Solution solution = solve(system, weights, Eigen::VectorXd(), unknowns, options);
    if (solution.termination == Termination::Converged) {
      unknowns = std::move(solution.unknowns);
    }
  }
}

}  // namespace

Expected<Unknowns> estimate_nuisance_parameters(const System& system, const Arm& arm, const Recording& recording) {
  return estimate_nuisance_parameters(system, arm, recording, all_tips(system, arm));
}

Expected<Unknowns> estimate_nuisance_parameters(const System& system, const Arm& arm, const Recording& recording,
                                                const std::vector<Tips>& tips) {
  const Constraints& constraints = *system.constraints;
  std::vector<Tips> balls;
  std::vector<std::vector<Tips>> by_group(constraints.groups.size());
  for (const Tips& of_feature : tips) {
    if (of_feature.feature->shared_radius()) {
      balls.push_back(of_feature);
    }
    if (of_feature.feature->group) {
      by_group[*of_feature.feature->group].push_back(of_feature);
    }
  }
  Unknowns unknowns;
  unknowns.shared.resize(system.shared_size());
  estimate_radii(balls, constraints, unknowns.shared);
  for (std::size_t i = 0; i < by_group.size(); ++i) {
    GroupState& group = unknowns.groups.emplace_back();
    const std::string first = called(*by_group[i].front().feature, constraints, recording);
    if (constraints.groups[i].has_pose) {
      auto estimated = estimate_pose(by_group[i], unknowns.shared, constraints.groups[i], first);
      if (!estimated) {
        return tl::unexpected(estimated.error());
      }
      group = std::move(*estimated);
      continue;
    }
    if (constraints.groups[i].has_axis) {
      auto estimated = estimate_planes(by_group[i], constraints, first);
      if (!estimated) {
        return tl::unexpected(estimated.error());
      }
      group = std::move(*estimated);
      continue;
    }
    group.values = Eigen::VectorXd::Zero(constraints.groups[i].size);
    for (const Tips& own : by_group[i]) {
      const FeatureConstraint& feature = *own.feature;
      const auto centre = feature.is<Coincide>()
                              ? std::optional<Eigen::Vector3d>(own.centres.rowwise().mean())
                              : point_at_distances(own.centres, distances_from_centre(own, unknowns.shared));
      if (!centre) {
        return no_solution(
            fmt::format("the centre of {} cannot be determined from its {} readings: at least four are needed, "
                        "and not all in one plane",
                        called(feature, constraints, recording), feature.size()));
      }
      group.values.segment<3>(feature.offset) = *centre;
    }
  }
  refine_radii(system, arm, unknowns);
  return unknowns;
}

void satisfy_distances(const Constraints& constraints, Unknowns& unknowns) {
  for (std::size_t g = 0; g < unknowns.groups.size(); ++g) {
    std::vector<const DistanceConstraint*> distances;
    for (const auto& distance : constraints.distances) {
      if (distance.binds && constraints.features[distance.first].group == static_cast<int>(g)) {
        distances.push_back(&distance);
      }
    }
    Eigen::VectorXd& values = unknowns.groups[g].values;
    RowMatrix slope(static_cast<Eigen::Index>(distances.size()), values.size());
    Eigen::VectorXd miss(slope.rows());
    for (int iteration = 0; iteration < 20 && !distances.empty(); ++iteration) {
      for (Eigen::Index i = 0; i < miss.size(); ++i) {
        miss[i] = weighted_distance(*distances[i], constraints, 1.0, values.data(), slope.row(i).data());
      }
      const Eigen::VectorXd step = slope.completeOrthogonalDecomposition().solve(miss);
      values -= step;
      if (step.norm() <= 1e-14 * values.norm()) {
        break;
      }
    }
  }
}

}  // namespace artcal
