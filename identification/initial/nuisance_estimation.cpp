#include "identification/initial/nuisance_estimation.h"

#include <optional>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include "core/kabsch.h"
#include "identification/initial/ball_start.h"
#include "identification/initial/plane_start.h"
#include "identification/least_squares/problem.h"
#include "identification/least_squares/residual.h"
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

// The rigid motion that takes `from` to `onto` with the least squares (Kabsch 1976); nothing for points on a line.
std::optional<Rigid> align(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& onto) {
  const Eigen::Vector3d from_mean = from.rowwise().mean();
  const Eigen::Vector3d onto_mean = onto.rowwise().mean();
  const Eigen::Matrix3d moment = (onto.colwise() - onto_mean) * (from.colwise() - from_mean).transpose();
  const Rotation rotation = rotation_of_moment(moment);
  if (!(rotation.shares[1] > 1e-9 * rotation.shares[0])) {
    return std::nullopt;
  }
  Rigid onto_from{rotation.rotation, {}};
  onto_from.translation = onto_mean - onto_from.rotation * from_mean;
  return onto_from;
}

// Gauss-Newton on the six numbers of a pose, all posed features of the group together. False if they do not tell it.
bool refine_pose(const std::vector<Tips>& features, const Eigen::VectorXd& shared, GroupState& group) {
  for (int iteration = 0; iteration < 50; ++iteration) {
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
    for (const Tips& tips : features) {
      const FeatureResidual residual(*tips.feature, group.reference, group.values.data(), shared.data());
      for (int k = 0; k < tips.feature->size(); ++k) {
        const Residual r = residual.at(k, tips.centres.col(k), tips.radii[k], true);
        const auto slope = r.by_unknowns.topRows(r.rows);
        normal += slope.transpose() * slope;
        gradient += slope.transpose() * r.value.head(r.rows);
      }
    }
    const Eigen::Matrix<double, 6, 1> unit = normal.diagonal().cwiseSqrt().cwiseInverse();
    const auto scaled = (unit.asDiagonal() * normal * unit.asDiagonal()).eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(scaled, Eigen::EigenvaluesOnly);
    if (!(eigen.eigenvalues()[0] > 1e-12)) {
      return false;
    }
    const Eigen::Matrix<double, 6, 1> step = -normal.ldlt().solve(gradient);
    group.values.head<6>() += step;
    if (step.norm() <= 1e-12 * (1.0 + group.values.head<6>().norm())) {
      break;
    }
  }
  group.reference.rotation *= rotation_of(group.values.head<3>());
  group.values.head<3>().setZero();
  return true;
}

Expected<void> estimate_pose(const std::vector<Tips>& features, const Eigen::VectorXd& shared,
                             const std::string& called, GroupState& group) {
  std::vector<Eigen::Vector3d> from;
  std::vector<Eigen::Vector3d> onto;
  std::vector<Eigen::Vector3d> planes_from;
  std::vector<Eigen::Vector3d> planes_onto;
  for (const Tips& tips : features) {
    const FeatureConstraint& feature = *tips.feature;
    if (feature.kind == ConstraintKind::Coincide) {
      from.insert(from.end(), feature.known.begin(), feature.known.end());
      for (const auto& tip : tips.centres.colwise()) {
        onto.emplace_back(tip);
      }
    } else if (feature.kind == ConstraintKind::OnPlane) {
      // The middle of a plane's readings for the point of it that is certified: near enough to begin with.
      planes_from.push_back(feature.known.front() + tips.radii.mean() * feature.normal);
      planes_onto.emplace_back(tips.centres.rowwise().mean());
    } else {
      if (const auto centre = point_at_distances(tips.centres, distances_from_centre(tips, shared))) {
        from.push_back(feature.known.front());
        onto.push_back(*centre);
      }
    }
  }
  if (from.size() < 3) {
    from.insert(from.end(), planes_from.begin(), planes_from.end());
    onto.insert(onto.end(), planes_onto.begin(), planes_onto.end());
  }
  const auto matrix = [](const std::vector<Eigen::Vector3d>& points) {
    return Eigen::Matrix3Xd::Map(points.empty() ? nullptr : points.front().data(), 3,
                                 static_cast<Eigen::Index>(points.size()));
  };
  const auto pose = from.size() < 3 ? std::nullopt : align(matrix(from), matrix(onto));
  if (!pose) {
    return no_solution(
        fmt::format("the pose of the artefact of {} cannot be determined: readings on at least three of its "
                    "points that are not on a line are needed",
                    called));
  }
  group.reference.rotation = pose->rotation;
  group.values = Eigen::VectorXd::Zero(6);
  group.values.segment<3>(3) = pose->translation;
  if (!refine_pose(features, shared, group)) {
    return no_solution(
        fmt::format("the pose of the artefact of {} cannot be determined from readings on these planes: three "
                    "are needed, no two of them parallel",
                    called));
  }
  return {};
}

// Radii that no certificate tells: each ball's from its own readings, then their mean over the placements.
void estimate_radii(const std::vector<Tips>& balls, const Constraints& constraints, Eigen::VectorXd& shared) {
  for (Eigen::Index s = 0; s < shared.size(); ++s) {
    shared[s] = constraints.shared[s].certified;
    double sum = 0.0;
    int count = 0;
    for (const Tips& tips : balls) {
      if (tips.feature->shared_radius != s || constraints.shared[s].u > 0.0) {
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
    Solution solution = solve(system, weights, Eigen::VectorXd(), unknowns);
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
    if (of_feature.feature->shared_radius >= 0) {
      balls.push_back(of_feature);
    }
    if (of_feature.feature->group >= 0) {
      by_group[of_feature.feature->group].push_back(of_feature);
    }
  }
  Unknowns unknowns;
  unknowns.shared.resize(system.shared_size());
  estimate_radii(balls, constraints, unknowns.shared);
  for (std::size_t i = 0; i < by_group.size(); ++i) {
    GroupState& group = unknowns.groups.emplace_back();
    const std::string first = called(*by_group[i].front().feature, constraints, recording);
    if (constraints.groups[i].has_pose) {
      if (auto estimated = estimate_pose(by_group[i], unknowns.shared, first, group); !estimated) {
        return tl::unexpected(estimated.error());
      }
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
      const auto centre = feature.kind == ConstraintKind::Coincide
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
