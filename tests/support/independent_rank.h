#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <ceres/jet.h>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "acquisition/arm/parameters.h"
#include "artefacts/virtual_probing/virtual_probing.h"
#include "tests/support/forward_kinematics.h"

/// What readings can tell of an arm, a second time: forward kinematics by 4×4 matrices, derivatives by automatic
/// differentiation, the unknown points, planes and poses as columns of their own, one SVD of everything. Nothing here
/// is taken from the pass, the residuals or the coupling analysis.
namespace artcal::testing {

struct IndependentRank {
  Eigen::MatrixXd jacobian;    ///< of the parameters alone, unknowns projected out; mm and rad times `angle_scale`
  Eigen::VectorXd scale;       ///< a parameter = scale · the jacobian's unit
  Eigen::VectorXd values;      ///< singular values, padded with zeros to one a parameter
  Eigen::MatrixXd null_space;  ///< orthonormal, in the jacobian's units
  int rank = 0;
  bool is_clear = true;  ///< no singular value lies where it is neither zero nor a real one
};

/// The tips' derivatives by the parameters, 3 × parameters for each reading.
inline std::vector<Eigen::MatrixXd> tip_derivatives(const Arm& arm, const Recording& recording,
                                                    const std::vector<Parameter>& parameters,
                                                    std::vector<Eigen::Vector3d>& tips) {
  using Jet = ceres::Jet<double, 1>;
  std::vector<Eigen::MatrixXd> all;
  for (Eigen::Index i = 0; i < recording.joints.cols(); ++i) {
    std::vector<Jet> q;
    for (const double angle : recording.joints.col(i)) q.emplace_back(angle);
    const int probe = recording.readings[static_cast<std::size_t>(i)].probe;
    Eigen::MatrixXd derivative(3, static_cast<Eigen::Index>(parameters.size()));
    ArmNumbers<Jet> numbers(arm);
    for (Eigen::Index p = 0; p < derivative.cols(); ++p) {
      Jet& number = numbers.at(parameters[static_cast<std::size_t>(p)]);
      number.v[0] = 1.0;
      const auto tip = tip_in_base(numbers, q, probe);
      number.v[0] = 0.0;
      for (int axis = 0; axis < 3; ++axis) derivative(axis, p) = tip[axis].v[0];
    }
    const auto tip = tip_in_base(numbers, q, probe);
    tips.emplace_back(tip[0].a, tip[1].a, tip[2].a);
    all.push_back(std::move(derivative));
  }
  return all;
}

/// Readings of one unknown thing (a point, ball, plane, anchor, or the pose of a placement).
using Members = std::vector<std::size_t>;

inline Eigen::Vector3d mean_of(const std::vector<Eigen::Vector3d>& tips, const Members& members) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::size_t i : members) sum += tips[i];
  return sum / static_cast<double>(members.size());
}

/// The centre from which the tips are as far as `distances` say, or all equally far where these are empty: the
/// differences of the squares are linear in the centre.
inline Eigen::Vector3d centre_of(const std::vector<Eigen::Vector3d>& tips, const Members& members,
                                 const std::vector<double>& distances) {
  const Eigen::Vector3d middle = mean_of(tips, members);
  Eigen::MatrixX4d a(static_cast<Eigen::Index>(members.size()), 4);
  Eigen::VectorXd b(a.rows());
  for (Eigen::Index k = 0; k < a.rows(); ++k) {
    const Eigen::Vector3d p = tips[members[static_cast<std::size_t>(k)]] - middle;
    a.row(k) << 2.0 * p.transpose(), 1.0;
    b[k] = p.squaredNorm() - (distances.empty() ? 0.0 : std::pow(distances[static_cast<std::size_t>(k)], 2));
  }
  return middle + a.completeOrthogonalDecomposition().solve(b).head<3>();
}

inline IndependentRank independent_rank(const Arm& arm, const VirtualRecording& made, ReadingKind kind,
                                        double angle_scale) {
  const Recording& recording = made.recording;
  const auto parameters = parameters_of(arm);
  std::vector<Eigen::Vector3d> tips;
  const auto derivatives = tip_derivatives(arm, recording, parameters, tips);
  std::map<std::pair<std::string, std::string>, Members> things;
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    const auto& reading = recording.readings[i];
    const std::string& placement = recording.placements.name(reading.placement);
    const bool posed = kind == ReadingKind::Plate || kind == ReadingKind::FrameCoordinates;
    const bool known = kind == ReadingKind::BaseCoordinates;
    things[{known ? "" : placement, known || posed ? "" : recording.features.name(reading.feature)}].push_back(i);
  }
  const auto p = static_cast<Eigen::Index>(parameters.size());
  std::vector<Eigen::RowVectorXd> rows;
  Eigen::Index unknowns = 0;
  const auto add = [&](const Eigen::RowVectorXd& by_arm, Eigen::Index first, const Eigen::RowVectorXd& by_unknowns) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(p + 200);
    row.head(p) = by_arm;
    row.segment(p + first, by_unknowns.size()) = by_unknowns;
    rows.push_back(row);
  };
  if (kind == ReadingKind::Distance) {
    for (auto thing = things.begin(); thing != things.end(); ++thing) {
      const auto first = thing->second.front();
      const auto second = (++thing)->second.front();
      const Eigen::Vector3d along = (tips[second] - tips[first]).normalized();
      add(along.transpose() * (derivatives[second] - derivatives[first]), 0, Eigen::RowVectorXd(0));
    }
  } else {
    for (const auto& [name, members] : things) {
      std::vector<double> lengths;
      for (const std::size_t i : members) lengths.push_back(recording.readings[i].length);
      const bool round = kind == ReadingKind::Sphere || kind == ReadingKind::UnknownSphere;
      const Eigen::Vector3d centre = kind == ReadingKind::Length ? centre_of(tips, members, lengths)
                                     : round                     ? centre_of(tips, members, {})
                                                                 : mean_of(tips, members);
      Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
      for (const std::size_t i : members) spread += (tips[i] - centre) * (tips[i] - centre).transpose();
      const Eigen::JacobiSVD<Eigen::Matrix3d> axes(spread, Eigen::ComputeFullU);
      for (const std::size_t i : members) {
        const Eigen::Vector3d from = tips[i] - centre;
        switch (kind) {
          case ReadingKind::BaseCoordinates:
            for (int axis = 0; axis < 3; ++axis) add(derivatives[i].row(axis), 0, Eigen::RowVectorXd(0));
            break;
          case ReadingKind::Point:
          case ReadingKind::FrameCoordinates:
          case ReadingKind::Plate:
            for (int axis = 0; axis < 3; ++axis) {
              Eigen::RowVectorXd by_pose = Eigen::RowVectorXd::Zero(kind == ReadingKind::Point ? 3 : 6);
              by_pose[axis] = -1.0;
              if (by_pose.size() == 6) {
                // A motion of the artefact: its turning about the middle, in units of the angle scale.
                for (int turn = 0; turn < 3; ++turn) {
                  by_pose[3 + turn] = -Eigen::Vector3d::Unit(turn).cross(from)[axis] / angle_scale;
                }
              }
              add(derivatives[i].row(axis), unknowns, by_pose);
            }
            break;
          case ReadingKind::Plane:
          case ReadingKind::LevelPlane: {
            const Eigen::Vector3d normal = axes.matrixU().col(2);
            add(normal.transpose() * derivatives[i], unknowns,
                Eigen::RowVector3d(-1.0, axes.matrixU().col(0).dot(from) / angle_scale,
                                   axes.matrixU().col(1).dot(from) / angle_scale));
            break;
          }
          default: {
            const Eigen::Vector3d out = from.normalized();
            Eigen::RowVectorXd by_place(kind == ReadingKind::UnknownSphere ? 4 : 3);
            by_place.head<3>() = -out.transpose();
            if (by_place.size() == 4) by_place[3] = -1.0;
            add(out.transpose() * derivatives[i], unknowns, by_place);
          }
        }
      }
      unknowns += kind == ReadingKind::BaseCoordinates                                  ? 0
                  : kind == ReadingKind::FrameCoordinates || kind == ReadingKind::Plate ? 6
                  : kind == ReadingKind::UnknownSphere                                  ? 4
                                                                                        : 3;
    }
  }
  IndependentRank result;
  result.scale.resize(p);
  for (Eigen::Index i = 0; i < p; ++i) {
    result.scale[i] = parameters[static_cast<std::size_t>(i)].is_angle() ? 1.0 / angle_scale : 1.0;
  }
  Eigen::MatrixXd by_arm(static_cast<Eigen::Index>(rows.size()), p);
  Eigen::MatrixXd by_unknowns(by_arm.rows(), unknowns);
  for (Eigen::Index i = 0; i < by_arm.rows(); ++i) {
    by_arm.row(i) = rows[static_cast<std::size_t>(i)].head(p).cwiseProduct(result.scale.transpose());
    by_unknowns.row(i) = rows[static_cast<std::size_t>(i)].segment(p, unknowns);
  }
  if (unknowns > 0) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(by_unknowns, Eigen::ComputeThinU);
    const auto seen = (svd.singularValues().array() > 1e-9 * svd.singularValues()[0]).count();
    const Eigen::MatrixXd u = svd.matrixU().leftCols(seen);
    by_arm -= (u * (u.transpose() * by_arm)).eval();
    by_arm -= (u * (u.transpose() * by_arm)).eval();
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(by_arm, Eigen::ComputeFullV);
  result.jacobian = by_arm;
  result.values = Eigen::VectorXd::Zero(p);
  result.values.head(svd.singularValues().size()) = svd.singularValues();
  // Readings in one posture at each point determine nothing: then all singular values are rounding.
  const Eigen::ArrayXd relative = result.values.array() / std::max(1.0, result.values[0]);
  result.rank = static_cast<int>((relative > 1e-9).count());
  result.is_clear = ((relative > 1e-11) && (relative < 1e-6)).count() == 0;
  result.null_space = svd.matrixV().rightCols(p - result.rank);
  return result;
}

}  // namespace artcal::testing
