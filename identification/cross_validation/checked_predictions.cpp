#include "identification/cross_validation/checked_predictions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <Eigen/Cholesky>

namespace artcal {
namespace {

/// A linear combination Σ gradient · tip over readings.
struct Combination {
  std::vector<int> readings;
  std::vector<Eigen::Vector3d> gradients;

  void add(const Combination& other, double sign) {
    readings.insert(readings.end(), other.readings.begin(), other.readings.end());
    for (const Eigen::Vector3d& gradient : other.gradients) {
      gradients.push_back(sign * gradient);
    }
  }
};

/// Answers to a placement's readings by one arm: tips by probe.
class Predictor {
 public:
  Predictor(const Recording& recording, const Constraints& placement, const Evaluation& evaluation, const Arm& arm,
            const UncertaintySources& sources)
      : recording_(recording), placement_(placement), evaluation_(evaluation) {
    for (int probe = 0; probe < static_cast<int>(arm.probes.size()); ++probe) {
      arms_.emplace_back(arm, sources, probe);
    }
    Eigen::Index first = 0;
    for (const FeatureConstraint& feature : placement.features) {
      first_.push_back(first);
      first += feature.size();
    }
  }

  /// How the measured place of a feature answers to its tips, along a direction.
  [[nodiscard]] Combination place(int index, const Eigen::Vector3d& direction) const {
    const FeatureConstraint& feature = placement_.features[index];
    Combination combination{feature.readings, {}};
    const int count = feature.size();
    if (!feature.has_centre()) {
      combination.gradients.assign(static_cast<std::size_t>(count), direction / count);
      return combination;
    }
    Eigen::Matrix3Xd normals(3, count);
    for (int k = 0; k < count; ++k) {
      normals.col(k) = (evaluation_.tips[first_[index] + k] - evaluation_.points[index]).normalized();
    }
    const Eigen::Vector3d answer = (normals * normals.transpose()).ldlt().solve(direction);
    for (int k = 0; k < count; ++k) {
      combination.gradients.emplace_back(answer.dot(normals.col(k)) * normals.col(k));
    }
    return combination;
  }

  [[nodiscard]] Combination distance(int first, int second) const {
    const Eigen::Vector3d direction = (evaluation_.points[second] - evaluation_.points[first]).normalized();
    Combination both = place(second, direction);
    both.add(place(first, direction), -1.0);
    return both;
  }

  /// `certified`: see CheckedPrediction.
  [[nodiscard]] CheckedPrediction prediction(double error, const Combination& combination, double u_certified,
                                             const std::array<int, 3>& certified) const {
    std::vector<UncertainTip> tips;
    for (const int reading : combination.readings) {
      tips.push_back(arm_of(reading).tip(recording_.joints.col(reading)));
    }
    const UncertainArm& any = arm_of(combination.readings.front());
    const double of_arm = any.without_noise().of_combination(tips, combination.gradients);
    const double all = any.of_combination(tips, combination.gradients);
    return {error, of_arm, std::hypot(std::sqrt(std::max(0.0, all * all - of_arm * of_arm)), u_certified), u_certified,
            certified};
  }

  /// What two features are certified by.
  [[nodiscard]] std::array<int, 3> certified_by(int first, int second) const {
    const FeatureConstraint& feature = placement_.features[first];
    return {feature.artefact, feature.feature, placement_.features[second].feature};
  }

  [[nodiscard]] Eigen::Index first_of(int feature) const { return first_[feature]; }

 private:
  [[nodiscard]] const UncertainArm& arm_of(int reading) const {
    return arms_[static_cast<std::size_t>(recording_.readings[static_cast<std::size_t>(reading)].probe)];
  }

  const Recording& recording_;
  const Constraints& placement_;
  const Evaluation& evaluation_;
  std::vector<UncertainArm> arms_;
  std::vector<Eigen::Index> first_;  ///< reading of each feature, among all of the evaluation
};

bool is_place(const FeatureConstraint& feature) { return feature.is<OnBall>() || feature.is<Coincide>(); }

void add_lengths(const Constraints& placement, const Evaluation& evaluation, const Predictor& predictor,
                 std::vector<CheckedPrediction>& predictions) {
  for (std::size_t d = 0; d < placement.distances.size(); ++d) {
    const DistanceConstraint& distance = placement.distances[d];
    if (is_place(placement.features[distance.first])) {
      predictions.push_back(predictor.prediction(evaluation.lengths[d].error,
                                                 predictor.distance(distance.first, distance.second), distance.u,
                                                 predictor.certified_by(distance.first, distance.second)));
    }
  }
}

// Of each certified place of a plate to the one farthest from it.
void add_patterns(const Constraints& placement, const Evaluation& evaluation, const Predictor& predictor,
                  std::vector<CheckedPrediction>& predictions) {
  std::map<int, std::vector<int>> by_group;
  for (int f = 0; f < static_cast<int>(placement.features.size()); ++f) {
    const FeatureConstraint& feature = placement.features[f];
    if (feature.location == Location::Posed && is_place(feature) && !feature.known.empty()) {
      by_group[*feature.group].push_back(f);
    }
  }
  const auto certified = [&](int feature) { return placement.features[feature].known.front(); };
  const auto u_of = [&](int f) {
    const FeatureConstraint& feature = placement.features[f];
    return placement.artefacts[feature.artefact].features[feature.feature].u_at;
  };
  for (const auto& [group, features] : by_group) {
    for (const int first : features) {
      const int second = *std::max_element(features.begin(), features.end(), [&](int a, int b) {
        return (certified(a) - certified(first)).norm() < (certified(b) - certified(first)).norm();
      });
      const double truth = (certified(second) - certified(first)).norm();
      const double measured = (evaluation.points[second] - evaluation.points[first]).norm();
      if (truth > 0.0) {
        predictions.push_back(predictor.prediction(measured - truth, predictor.distance(first, second),
                                                   std::hypot(u_of(first), u_of(second)),
                                                   predictor.certified_by(first, second)));
      }
    }
  }
}

void add_coordinates(const Constraints& placement, const Evaluation& evaluation, const Predictor& predictor,
                     std::vector<CheckedPrediction>& predictions) {
  for (int f = 0; f < static_cast<int>(placement.features.size()); ++f) {
    const FeatureConstraint& feature = placement.features[f];
    if (feature.location != Location::Base || !feature.is<Coincide>()) {
      continue;
    }
    for (int k = 0; k < feature.size(); ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        const Combination coordinate{{feature.readings[k]}, {Eigen::Vector3d::Unit(axis)}};
        predictions.push_back(predictor.prediction(evaluation.offsets[predictor.first_of(f) + k][axis], coordinate,
                                                   feature.u, {-1, -1, -1}));
      }
    }
  }
}

}  // namespace

std::vector<CheckedPrediction> check_predictions(const Recording& recording, const Constraints& placement,
                                                 const Evaluation& evaluation, const Arm& arm,
                                                 const UncertaintySources& sources) {
  const Predictor predictor(recording, placement, evaluation, arm, sources);
  std::vector<CheckedPrediction> predictions;
  add_lengths(placement, evaluation, predictor, predictions);
  if (predictions.empty()) {
    add_patterns(placement, evaluation, predictor, predictions);
  }
  add_coordinates(placement, evaluation, predictor, predictions);
  return predictions;
}

}  // namespace artcal
