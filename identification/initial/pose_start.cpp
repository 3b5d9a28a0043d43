#include "identification/initial/pose_start.h"

#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "core/kabsch.h"
#include "identification/initial/ball_start.h"
#include "identification/least_squares/residual.h"

namespace artcal {
namespace {

/// What is certified, and where an arm has it.
struct Matches {
  std::vector<Eigen::Vector3d> from;  ///< in the artefact's frame
  std::vector<Eigen::Vector3d> onto;  ///< in the base frame

  void add(const Eigen::Vector3d& certified, const Eigen::Vector3d& found) {
    from.push_back(certified);
    onto.push_back(found);
  }
};

Eigen::Map<const Eigen::Matrix3Xd> matrix(const std::vector<Eigen::Vector3d>& points) {
  return {points.empty() ? nullptr : points.front().data(), 3, static_cast<Eigen::Index>(points.size())};
}

// Points and centres; of planes, where there are fewer than three of these and no line, the middle of the readings for
// the point that is certified: near enough to begin with.
Matches matches_of(const std::vector<Tips>& features, const Eigen::VectorXd& shared, bool on_line) {
  Matches points;
  Matches planes;
  for (const Tips& tips : features) {
    const FeatureConstraint& feature = *tips.feature;
    if (feature.is<Coincide>()) {
      for (int k = 0; k < feature.size(); ++k) {
        points.add(feature.known[k], tips.centres.col(k));
      }
    } else if (const auto* plane = feature.as<OnPlane>()) {
      planes.add(feature.known.front() + tips.radii.mean() * *plane->normal, tips.centres.rowwise().mean());
    } else if (const auto centre = point_at_distances(tips.centres, distances_from_centre(tips, shared))) {
      points.add(feature.known.front(), *centre);
    }
  }
  if (points.from.size() < 3 && !on_line) {
    for (std::size_t i = 0; i < planes.from.size(); ++i) {
      points.add(planes.from[i], planes.onto[i]);
    }
  }
  return points;
}

// The rigid motion with the least squares (Kabsch 1976); nothing for points on a line.
std::optional<Rigid> align_matches(const Matches& points) {
  if (points.from.size() < 3) {
    return std::nullopt;
  }
  const auto from = matrix(points.from);
  const auto onto = matrix(points.onto);
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

// The same for points on a line, turned about it in any way; nothing where they are one point.
std::optional<Rigid> align_line(const Matches& points, const PointLine& line) {
  if (points.from.size() < 2) {
    return std::nullopt;
  }
  const auto from = matrix(points.from);
  const auto onto = matrix(points.onto);
  const Eigen::Vector3d from_mean = from.rowwise().mean();
  const Eigen::Vector3d onto_mean = onto.rowwise().mean();
  const Eigen::Vector3d along = line.artefact_from_line.col(2);
  const Eigen::RowVectorXd places = along.transpose() * (from.colwise() - from_mean);
  const Eigen::Vector3d direction = (onto.colwise() - onto_mean) * places.transpose();
  if (!(places.squaredNorm() > 0.0) || !(direction.norm() > 1e-6 * places.squaredNorm())) {
    return std::nullopt;
  }
  Rigid onto_from{rotation_onto(along, direction), {}};
  onto_from.translation = onto_mean - onto_from.rotation * from_mean;
  return onto_from;
}

/// Normal equations of a pose, all readings counting alike.
struct PoseSystem {
  Eigen::MatrixXd normal;
  Eigen::VectorXd gradient;
  double squares = 0.0;

  PoseSystem(const std::vector<Tips>& features, const Eigen::VectorXd& shared, const GroupState& group)
      : normal(Eigen::MatrixXd::Zero(group.values.size(), group.values.size())),
        gradient(Eigen::VectorXd::Zero(group.values.size())) {
    for (const Tips& tips : features) {
      const FeatureResidual residual(*tips.feature, group.reference, group.values.data(), shared.data());
      for (int k = 0; k < tips.feature->size(); ++k) {
        const Residual r = residual.at(k, tips.centres.col(k), tips.radii[k], true);
        const auto slope = r.by_unknowns.topLeftCorner(r.rows, residual.columns());
        normal += slope.transpose() * slope;
        gradient += slope.transpose() * r.value.head(r.rows);
        squares += r.value.head(r.rows).squaredNorm();
      }
    }
  }

  [[nodiscard]] bool is_regular() const {
    const Eigen::VectorXd unit = normal.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = unit.asDiagonal() * normal * unit.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled, Eigen::EigenvaluesOnly);
    return eigen.eigenvalues()[0] > 1e-12;
  }

  [[nodiscard]] Eigen::VectorXd step(double damping) const {
    Eigen::MatrixXd damped = normal;
    damped.diagonal() *= 1.0 + damping;
    return -damped.ldlt().solve(gradient);
  }
};

// Gauss-Newton on the unknowns of a pose, damped (Marquardt 1963) where that does not lower the squares. Returns the
// sum of squares; nothing where the readings do not determine the pose.
std::optional<double> refine_pose(const std::vector<Tips>& features, const Eigen::VectorXd& shared, GroupState& group) {
  double damping = 0.0;
  PoseSystem here(features, shared, group);
  for (int iteration = 0; iteration < 100; ++iteration) {
    if (!here.is_regular()) {
      return std::nullopt;
    }
    const Eigen::VectorXd step = here.step(damping);
    GroupState next = group;
    next.values += step;
    PoseSystem there(features, shared, next);
    if (there.squares > here.squares * (1.0 + 1e-9)) {
      damping = std::max(1e-3, 10.0 * damping);
    } else {
      group = std::move(next);
      here = std::move(there);
      damping = damping > 1e-6 ? 0.1 * damping : 0.0;
    }
    if (step.norm() <= 1e-12 * (1.0 + group.values.norm())) {
      break;
    }
  }
  const Rigid pose = base_from_artefact(group);
  group.reference.rotation = pose.rotation;
  group.values.head(group.reference.turn == PoseTurn::Free ? 3 : 2).setZero();
  return here.squares;
}

Error not_determined(const std::string& called, const char* needed) {
  return {ErrorCode::NoSolution,
          fmt::format("the pose of the artefact of {} cannot be determined: {}", called, needed),
          {}};
}

// The best of four turns about that of the scaled pose; of all, where that was not found.
std::optional<GroupState> best_turn(const std::vector<Tips>& features, const Eigen::VectorXd& shared,
                                    const PointLine& line, const GroupState& scaled) {
  const GroupState start = with_free_turn(scaled);
  std::optional<GroupState> best;
  double least = 0.0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    GroupState candidate = turned_about_line(start, line, 0.5 * std::numbers::pi * quarter);
    const auto squares = refine_pose(features, shared, candidate);
    if (squares && (!best || *squares < least)) {
      least = *squares;
      best = std::move(candidate);
    }
  }
  return best;
}

}  // namespace

GroupState with_free_turn(const GroupState& scaled) {
  GroupState free;
  const Rigid pose = base_from_artefact(scaled);
  free.reference.rotation = pose.rotation;
  free.values = Eigen::VectorXd::Zero(6);
  free.values.segment<3>(3) = pose.translation;
  return turned_about_line(free, scaled.reference.line, std::atan2(scaled.values[6], scaled.values[5]));
}

GroupState turned_about_line(const GroupState& posed, const PointLine& line, double angle) {
  const Rigid pose = base_from_artefact(posed);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, line.artefact_from_line.col(2)).toRotationMatrix();
  GroupState turned = posed;
  turned.reference.rotation = pose.rotation * turn;
  turned.values.setZero();
  turned.values.segment<3>(3) = pose * line.middle - turned.reference.rotation * line.middle;
  return turned;
}

Expected<GroupState> estimate_pose(const std::vector<Tips>& features, const Eigen::VectorXd& shared,
                                   const UnknownGroup& group, const std::string& called) {
  const Matches points = matches_of(features, shared, group.line.has_value());
  const auto pose = group.line ? align_line(points, *group.line) : align_matches(points);
  if (!pose) {
    return tl::unexpected(
        not_determined(called, group.line ? "readings on at least two of its points are needed, four on each ball"
                                          : "readings on at least two of its points are needed, or on three planes"));
  }
  GroupState state;
  state.reference.rotation = pose->rotation;
  if (!group.line) {
    state.values = Eigen::VectorXd::Zero(6);
    state.values.segment<3>(3) = pose->translation;
    if (!refine_pose(features, shared, state)) {
      return tl::unexpected(not_determined(
          called, "readings on at least two of its points are needed, or on three planes, no two of them parallel"));
    }
    return state;
  }
  state.reference.line = *group.line;
  state.reference.turn = group.turn == PoseTurn::Unseen ? PoseTurn::Unseen : PoseTurn::Scaled;
  state.values = Eigen::VectorXd::Zero(state.reference.turn == PoseTurn::Unseen ? 5 : 7);
  state.values.segment<3>(2) = pose->translation;
  const bool regular = refine_pose(features, shared, state).has_value();
  if (group.turn == PoseTurn::Free) {
    if (auto best = best_turn(features, shared, *group.line, state)) {
      return *best;
    }
  } else if (regular) {
    return state;
  }
  return tl::unexpected(not_determined(called, "its readings do not determine how it lies"));
}

}  // namespace artcal
