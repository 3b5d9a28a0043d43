#include "identification/uncertainty/unmodelled_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "artefacts/virtual_probing/postures.h"
#include "core/random.h"
#include "core/statistics.h"

namespace artcal {
namespace {

constexpr double confidence = 0.99;  // of calling a sound model wrong: one in a hundred
constexpr double coverage = 0.95;    // what Student's factor is for
constexpr double largest_scale = 1e3;
// mm; readings that agree to the last digits are no real ones, and errors beside them are rounding.
constexpr double least_real_noise = 1e-6;
constexpr int survey_postures = 200;

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
    if (feature.kind != ConstraintKind::OnBall && feature.kind != ConstraintKind::AtDistance) {
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

bool is_place(const FeatureConstraint& feature) {
  return feature.kind == ConstraintKind::OnBall || feature.kind == ConstraintKind::Coincide;
}

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
      by_group[feature.group].push_back(f);
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
    if (feature.location != Location::Base || feature.kind != ConstraintKind::Coincide) {
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

// Mean over a placement's predictions of (error/u)², where the arm's share of u is `scale` times as large.
double mean_square(const LeftOut& left, double scale) {
  double sum = 0.0;
  for (const CheckedPrediction& checked : left.predictions) {
    const double u = std::hypot(scale * checked.u_arm, checked.u_other);
    sum += u > 0.0 ? std::pow(checked.error / u, 2) : 0.0;
  }
  return sum / static_cast<double>(left.predictions.size());
}

double sum_over_placements(const std::vector<LeftOut>& left_out, double scale, Loss loss) {
  std::vector<double> squares;
  for (const LeftOut& left : left_out) {
    if (!left.predictions.empty()) {
      squares.push_back(mean_square(left, scale));
    }
  }
  return loss == Loss::None ? std::accumulate(squares.begin(), squares.end(), 0.0)
                            : static_cast<double>(squares.size()) * median(squares) / chi_squared_quantile(0.5, 1.0);
}

// Degrees of freedom of that sum (Satterthwaite): within a placement errors are taken for one; from placement to
// placement the error of a certified value is the same, and the more it is of u, the less does each placement add.
double effective_placements(const std::vector<LeftOut>& left_out) {
  struct Sums {
    double all = 0.0, squares = 0.0;
  };
  std::map<std::array<int, 3>, Sums> by_certified;
  double placements = 0.0;
  for (const LeftOut& left : left_out) {
    placements += left.predictions.empty() ? 0.0 : 1.0;
    std::map<std::array<int, 3>, double> own;
    for (const CheckedPrediction& checked : left.predictions) {
      const double u = std::hypot(checked.u_arm, checked.u_other);
      if (checked.certified[0] >= 0 && u > 0.0) {
        own[checked.certified] += std::pow(checked.u_certificate / u, 2) / static_cast<double>(left.predictions.size());
      }
    }
    for (const auto& [certified, share] : own) {
      by_certified[certified].all += share;
      by_certified[certified].squares += share * share;
    }
  }
  double squares = placements;
  for (const auto& [certified, sums] : by_certified) {
    squares += sums.all * sums.all - sums.squares;
  }
  return placements * placements / squares;
}

// The scale at which the sum is the number of placements; it falls with the scale.
double matching_scale(const std::vector<LeftOut>& left_out, double placements, Loss loss) {
  double low = 1.0, high = largest_scale;
  while (high / low > 1.0 + 1e-9) {
    const double middle = std::sqrt(low * high);
    (sum_over_placements(left_out, middle, loss) > placements ? low : high) = middle;
  }
  return high;
}

// So few placements do not know a scale better: Student's factor over the normal one.
double of_few(double placements) {
  return student_coverage_factor(coverage, placements) / normal_quantile(0.5 * (1.0 + coverage));
}

// The scale with which 95 % intervals hold 95 % of coordinates of these variances with that error beside them. A mean
// over the variances would not do: where they differ from posture to posture, the small ones hold too little. Those
// that the parameters hardly move count with half of the rms, so that they do not enlarge all others without
// bound.
double covering_scale(std::vector<double> variances, double error) {
  const double least =
      std::accumulate(variances.begin(), variances.end(), 0.0) / (4.0 * static_cast<double>(variances.size()));
  if (!(least > 0.0)) {
    return 1.0;
  }
  for (double& variance : variances) {
    variance = std::max(variance, least);
  }
  const auto share_held = [&](double scale) {
    double sum = 0.0;
    for (const double variance : variances) {
      const double limit = normal_quantile(0.5 * (1.0 + coverage)) * scale * std::sqrt(variance);
      sum += std::erf(limit / std::sqrt(2.0 * (variance + error * error)));
    }
    return sum / static_cast<double>(variances.size());
  };
  double low = 1.0, high = largest_scale;
  while (high / low > 1.0 + 1e-9) {
    const double middle = std::sqrt(low * high);
    (share_held(middle) < coverage ? low : high) = middle;
  }
  return high;
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

CrossValidation cross_validate(const std::vector<LeftOut>& left_out, bool effects_found, Loss loss) {
  CrossValidation found;
  for (const LeftOut& left : left_out) {
    found.placements += left.predictions.empty() ? 0 : 1;
    found.predictions += static_cast<int>(left.predictions.size());
  }
  if (found.placements == 0) {
    return found;
  }
  const double placements = found.placements;
  const double sum = sum_over_placements(left_out, 1.0, loss);
  found.ratio = std::sqrt(sum / placements);
  found.effective_placements = effective_placements(left_out);
  found.limit = std::sqrt(chi_squared_quantile(confidence, found.effective_placements) / found.effective_placements);
  if (found.ratio > (effects_found ? 1.0 : found.limit)) {
    found.scale = matching_scale(left_out, placements, loss) * of_few(found.effective_placements);
  }
  return found;
}

double unmodelled_point_error(const std::vector<LeftOut>& left_out, double noise) {
  double squares = 0.0;
  int freedom = 0;
  for (const LeftOut& left : left_out) {
    if (left.refusal.empty() && left.degrees_of_freedom > 0) {
      squares += left.squares;
      freedom += left.degrees_of_freedom;
    }
  }
  return freedom > 0 ? std::sqrt(std::max(0.0, squares / freedom - noise * noise)) : 0.0;
}

void add_point_error(double error, const Identification& result, CrossValidation& found) {
  if (found.placements == 0 || !(error > 0.0) || result.free.empty()) {
    return;
  }
  UncertaintySources sources;
  for (const int index : result.free) {
    sources.parameters.push_back(result.parameters[index].parameter);
  }
  sources.covariance = result.covariance;
  const UncertainArm arm(result.arm, std::move(sources));
  RandomStream random(1, "unmodelled error");
  std::vector<double> variances;  // of coordinates
  for (int i = 0; i < survey_postures; ++i) {
    const Eigen::Vector3d of_point = arm.of_point(arm.tip(random_posture(result.arm, random))).diagonal();
    variances.insert(variances.end(), of_point.begin(), of_point.end());
  }
  found.point_error = error;
  found.scale = std::max(found.scale, covering_scale(std::move(variances), error) * of_few(found.effective_placements));
}

void enlarge_for_unmodelled_errors(const CrossValidation& found, Identification& result) {
  result.cross_validation = found;
  if (found.scale <= 1.0) {
    return;
  }
  result.covariance *= found.scale * found.scale;
  for (IdentifiedParameter& parameter : result.parameters) {
    parameter.u *= found.scale;
  }
  result.warnings.push_back(fmt::format(
      "unmodelled error: in {} placements left out, the arm identified without them is off by {:.2g} times its "
      "standard uncertainty (rms){}; the covariance and all standard uncertainties of this arm, its points and its "
      "lengths are enlarged by {:.2f} to what these placements show",
      found.placements, found.ratio,
      found.point_error > 0.0
          ? fmt::format(", and readings by {:.2g} mm a coordinate beyond the known noise", found.point_error)
          : std::string(),
      found.scale));
}

void judge_by_left_out(Loss loss, Identification& result) {
  if (!(result.noise > least_real_noise)) {
    return;
  }
  const bool effects_found = !result.model_study.findings.empty();
  CrossValidation found = cross_validate(result.left_out, effects_found, loss);
  const bool noise_exceeded =
      result.noise_is_given && result.chi_squared > chi_squared_quantile(0.999, result.degrees_of_freedom);
  if (effects_found || noise_exceeded || found.scale > 1.0) {
    // Where no noise was stated, it is what the residuals hold beside the effects that were found in them.
    const double known_noise =
        result.noise_is_given ? result.noise : result.noise * std::sqrt(result.model_study.remaining_variance);
    add_point_error(unmodelled_point_error(result.left_out, known_noise), result, found);
  }
  enlarge_for_unmodelled_errors(found, result);
}

}  // namespace artcal
