#include "identification/settle.h"

#include <optional>

#include <fmt/format.h>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "identification/residual.h"
#include "identification/rows.h"

namespace artcal {
namespace {

std::string called(const FeatureConstraint& feature, const Constraints& constraints, const Recording& recording) {
  const FeatureName name = name_of(feature, constraints, recording);
  return fmt::format("feature \"{}\" of artefact \"{}\" in placement \"{}\"", name.feature, name.artefact,
                     name.placement);
}

Eigen::Matrix3Xd tips_of(const System& system, const FeatureConstraint& feature, const std::vector<Sweep>& sweeps) {
  Eigen::Matrix3Xd tips(3, feature.size());
  for (int k = 0; k < feature.size(); ++k) {
    const int reading = feature.readings[k];
    tips.col(k) = sweeps[system.probes[reading]].tip_in_base(system.sines_of(reading));
  }
  return tips;
}

// The point at given distances from given points. Subtracting the mean of |p − c|² = ρ² leaves equations
// linear in c: 2 pᵀc = |p|² − ρ² + constant, with p from the points' own mean. Then Gauss-Newton.
std::optional<Eigen::Vector3d> trilaterate(const Eigen::Matrix3Xd& points, const std::vector<double>& distances) {
  const Eigen::Vector3d mean = points.rowwise().mean();
  const Eigen::Matrix3Xd p = points.colwise() - mean;
  Eigen::MatrixXd a(p.cols(), 4);
  Eigen::VectorXd b(p.cols());
  const Eigen::VectorXd rho = Eigen::VectorXd::Map(distances.data(), p.cols());
  const double size = p.norm() / std::sqrt(static_cast<double>(p.cols()));
  a.leftCols<3>() = 2.0 * p.transpose();
  a.col(3).setConstant(size);
  b = p.colwise().squaredNorm().transpose() - rho.cwiseAbs2();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
  qr.setThreshold(1e-4);
  if (p.cols() < 4 || qr.rank() < 4) {
    return std::nullopt;
  }
  Eigen::Vector3d c = qr.solve(b).head<3>();
  for (int iteration = 0; iteration < 50; ++iteration) {
    const Eigen::Matrix3Xd away = (-p).colwise() + c;
    const Eigen::VectorXd length = away.colwise().norm();
    if (!(length.minCoeff() > 0.0)) {
      return std::nullopt;
    }
    const Eigen::MatrixX3d slope = away.transpose().array().colwise() / length.array();
    const Eigen::Vector3d step = slope.colPivHouseholderQr().solve(rho - length);
    c += step;
    if (step.norm() <= 1e-13 * (size + c.norm())) {
      return c + mean;
    }
  }
  return c + mean;
}

// The rigid motion that takes `from` to `onto` with the least squares (Kabsch 1976); nothing for points on a line.
std::optional<Rigid> align(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& onto) {
  const Eigen::Vector3d from_mean = from.rowwise().mean();
  const Eigen::Vector3d onto_mean = onto.rowwise().mean();
  const Eigen::Matrix3d moment = (onto.colwise() - onto_mean) * (from.colwise() - from_mean).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (!(svd.singularValues()[1] > 1e-9 * svd.singularValues()[0])) {
    return std::nullopt;
  }
  Eigen::Vector3d sign(1.0, 1.0, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0);
  Rigid onto_from{svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose(), {}};
  onto_from.translation = onto_mean - onto_from.rotation * from_mean;
  return onto_from;
}

// Gauss-Newton on the six numbers of a pose, all posed features of the group together.
void refine_pose(const std::vector<const FeatureConstraint*>& features, const std::vector<Eigen::Matrix3Xd>& tips,
                 GroupState& group) {
  for (int iteration = 0; iteration < 50; ++iteration) {
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
    for (std::size_t f = 0; f < features.size(); ++f) {
      const FeatureResidual residual(*features[f], group.reference, group.values.data());
      for (int k = 0; k < features[f]->size(); ++k) {
        const Residual r = residual.at(k, tips[f].col(k), true);
        const auto slope = r.by_unknowns.topRows(r.rows);
        normal += slope.transpose() * slope;
        gradient += slope.transpose() * r.value.head(r.rows);
      }
    }
    const Eigen::Matrix<double, 6, 1> step = -normal.ldlt().solve(gradient);
    group.values.head<6>() += step;
    if (step.norm() <= 1e-12 * (1.0 + group.values.head<6>().norm())) {
      break;
    }
  }
  group.reference *= rotation_of(group.values.head<3>());
  group.values.head<3>().setZero();
}

Expected<void> settle_pose(const System& system, const Recording& recording, const std::vector<Sweep>& sweeps,
                           int index, GroupState& group) {
  std::vector<const FeatureConstraint*> features;
  std::vector<Eigen::Matrix3Xd> tips;
  std::vector<Eigen::Vector3d> from;
  std::vector<Eigen::Vector3d> onto;
  for (const auto& feature : system.constraints->features) {
    if (feature.group != index || feature.location != Location::Posed) {
      continue;
    }
    features.push_back(&feature);
    tips.push_back(tips_of(system, feature, sweeps));
    if (feature.demand == Demand::Coincide) {
      from.insert(from.end(), feature.known.begin(), feature.known.end());
      for (const auto& tip : tips.back().colwise()) {
        onto.emplace_back(tip);
      }
    } else if (const auto centre = trilaterate(tips.back(), feature.distances)) {
      from.push_back(feature.known.front());
      onto.push_back(*centre);
    }
  }
  const auto matrix = [](const std::vector<Eigen::Vector3d>& points) {
    return Eigen::Matrix3Xd::Map(points.empty() ? nullptr : points.front().data(), 3,
                                 static_cast<Eigen::Index>(points.size()));
  };
  const auto pose = from.size() < 3 ? std::nullopt : align(matrix(from), matrix(onto));
  if (!pose) {
    return no_solution(
        fmt::format("the pose of the artefact of {} cannot be told: readings on at least three of its "
                    "points that are not on a line are needed",
                    called(*features.front(), *system.constraints, recording)));
  }
  group.reference = pose->rotation;
  group.values.head<3>().setZero();
  group.values.segment<3>(3) = pose->translation;
  refine_pose(features, tips, group);
  return {};
}

}  // namespace

Expected<Unknowns> settle(const System& system, const Arm& arm, const Recording& recording) {
  const Constraints& constraints = *system.constraints;
  const auto sweeps = sweeps_of(system, arm);
  Unknowns unknowns(constraints.groups.size());
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    unknowns[i].values = Eigen::VectorXd::Zero(constraints.groups[i].size);
    if (constraints.groups[i].has_pose) {
      if (auto settled = settle_pose(system, recording, sweeps, static_cast<int>(i), unknowns[i]); !settled) {
        return tl::unexpected(settled.error());
      }
    }
  }
  for (const auto& feature : constraints.features) {
    if (feature.location != Location::Unknown) {
      continue;
    }
    const Eigen::Matrix3Xd tips = tips_of(system, feature, sweeps);
    const auto centre = feature.demand == Demand::Coincide ? std::optional<Eigen::Vector3d>(tips.rowwise().mean())
                                                           : trilaterate(tips, feature.distances);
    if (!centre) {
      return no_solution(
          fmt::format("the centre of {} cannot be told from its {} readings: at least four are needed, "
                      "and not all in one plane",
                      called(feature, constraints, recording), feature.size()));
    }
    unknowns[feature.group].values.segment<3>(feature.offset) = *centre;
  }
  return unknowns;
}

void satisfy_distances(const Constraints& constraints, Unknowns& unknowns) {
  for (std::size_t g = 0; g < unknowns.size(); ++g) {
    std::vector<const DistanceConstraint*> distances;
    for (const auto& distance : constraints.distances) {
      if (distance.binds && constraints.features[distance.first].group == static_cast<int>(g)) {
        distances.push_back(&distance);
      }
    }
    Eigen::VectorXd& values = unknowns[g].values;
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
