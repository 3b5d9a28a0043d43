#include "identification/problem/weights.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/statistics.h"
#include "identification/least_squares/residual.h"

namespace artcal {
namespace {

std::vector<double> distance_weights(const Constraints& constraints) {
  std::vector<double> weights;
  for (const auto& distance : constraints.distances) {
    weights.push_back(1.0 / distance.u);
  }
  return weights;
}

std::vector<double> shared_weights(const Constraints& constraints) {
  std::vector<double> weights;
  for (const auto& shared : constraints.shared) {
    weights.push_back(shared.u > 0.0 ? 1.0 / shared.u : 0.0);
  }
  return weights;
}

// Readings that see each artefact parameter.
std::vector<int> reading_counts(const Constraints& constraints) {
  std::vector<int> counts(constraints.shared.size(), 0);
  for (const auto& feature : constraints.features) {
    for (int axis = 0; feature.first_error && axis < 3; ++axis) {
      counts[*feature.first_error + axis] += feature.size();
    }
    if (const auto radius = feature.shared_radius()) {
      counts[*radius] += feature.size();
    }
  }
  return counts;
}

}  // namespace

Weights unit_weights(const Constraints& constraints) {
  Weights weights;
  for (const auto& feature : constraints.features) {
    weights.features.push_back({std::vector<double>(feature.readings.size(), 1.0), {}});
  }
  for (const auto& distance : constraints.distances) {
    weights.distances.push_back(
        std::sqrt(constraints.features[distance.first].size() + constraints.features[distance.second].size()));
  }
  const auto counts = reading_counts(constraints);
  for (std::size_t s = 0; s < counts.size(); ++s) {
    weights.shared.push_back(constraints.shared[s].u > 0.0 ? std::sqrt(counts[s]) : 0.0);
  }
  return weights;
}

Weights uniform_weights(const Constraints& constraints, double sigma) {
  Weights weights;
  for (const auto& feature : constraints.features) {
    weights.features.push_back({std::vector<double>(feature.readings.size(), 1.0 / std::hypot(sigma, feature.u)), {}});
  }
  weights.distances = distance_weights(constraints);
  weights.shared = shared_weights(constraints);
  return weights;
}

Weights posture_weights(const System& system, const Arm& arm, const Unknowns& unknowns, double encoder,
                        double probing) {
  const Constraints& constraints = *system.constraints;
  const auto kinematics_by_probe = forward_kinematics_of(system, arm);
  Weights weights;
  weights.distances = distance_weights(constraints);
  weights.shared = shared_weights(constraints);
  for (const auto& feature : constraints.features) {
    const GroupState& group = state_of(feature, unknowns);
    const FeatureResidual residual(feature, group.reference, group.values.data(), unknowns.shared.data());
    weights.features.push_back(posture_weights(system, feature, residual, kinematics_by_probe, arm, encoder, probing));
  }
  return weights;
}

FeatureWeights posture_weights(const System& system, const FeatureConstraint& feature, const FeatureResidual& residual,
                               const std::vector<ForwardKinematics>& kinematics_by_probe, const Arm& arm,
                               double encoder, double probing) {
  Eigen::Matrix3Xd by_joints(3, static_cast<Eigen::Index>(arm.joints.size()));
  FeatureWeights out;
  for (int k = 0; k < feature.size(); ++k) {
    const int reading = feature.readings[k];
    const ForwardKinematics& kinematics = kinematics_by_probe[system.probes[reading]];
    const Eigen::Vector3d tip = kinematics.tip_by_joints(system.sines_of(reading), by_joints.data());
    for (std::size_t i = 0; i < arm.joints.size(); ++i) {
      if (arm.joints[i].is_prismatic()) {
        by_joints.col(static_cast<Eigen::Index>(i)).setZero();  // its noise is a length, part of `probing`
      }
    }
    const Residual r = residual.at(k, tip, kinematics.tip_radius(), true);
    const Eigen::Matrix3d tip_covariance =
        probing * probing * Eigen::Matrix3d::Identity() + encoder * encoder * by_joints * by_joints.transpose();
    if (r.rows == 1) {
      const Eigen::RowVector3d slope = r.by_tip.row(0);
      const double variance = (slope * tip_covariance).dot(slope) + feature.u * feature.u;
      out.scalar.push_back(1.0 / std::sqrt(variance));
    } else {
      const auto slope = r.by_tip.topRows(r.rows);
      Eigen::MatrixXd covariance = slope * tip_covariance * slope.transpose();
      covariance.diagonal().array() += feature.u * feature.u;
      const Eigen::Matrix3d lower = Eigen::Matrix3d(covariance).llt().matrixL();
      out.matrix.emplace_back(lower.triangularView<Eigen::Lower>().solve(Eigen::Matrix3d::Identity()));
    }
  }
  return out;
}

Weights first_weights(const System& system, const Arm& arm, const Unknowns& unknowns, const Noise& noise) {
  if (noise.encoder) {
    return posture_weights(system, arm, unknowns, *noise.encoder, *noise.probing);
  }
  return noise.reading ? uniform_weights(*system.constraints, *noise.reading) : unit_weights(*system.constraints);
}

double typical_noise(const Weights& weights) {
  std::vector<double> sigmas;
  for (const auto& feature : weights.features) {
    for (const double weight : feature.scalar) {
      sigmas.push_back(1.0 / weight);
    }
    for (const auto& matrix : feature.matrix) {
      sigmas.push_back(1.0 / std::cbrt(matrix.determinant()));
    }
  }
  return median(sigmas);
}

}  // namespace artcal
