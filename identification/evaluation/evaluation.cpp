#include "identification/least_squares/evaluation_of_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <Eigen/Cholesky>

#include "identification/initial/ball_sides.h"
#include "identification/initial/ball_start.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/residual.h"
#include "identification/problem/tips.h"

namespace artcal {
namespace {

/// Sums of a set of deviations.
struct Sum {
  int count = 0;
  double squares = 0.0;
  double maximum = 0.0;

  void add(double deviation) {
    ++count;
    squares += deviation * deviation;
    maximum = std::max(maximum, std::abs(deviation));
  }
  void add(const Sum& other) {
    count += other.count;
    squares += other.squares;
    maximum = std::max(maximum, other.maximum);
  }
  [[nodiscard]] FeatureDeviation named(FeatureName name) const {
    return {std::move(name), count, count == 0 ? 0.0 : std::sqrt(squares / count), maximum};
  }
};

Eigen::Vector3d certified_point(const FeatureConstraint& feature, const Unknowns& unknowns) {
  switch (feature.location) {
    case Location::Unknown: return state_of(feature, unknowns).values.segment<3>(feature.offset);
    case Location::Posed: return base_from_artefact(state_of(feature, unknowns)) * feature.known.front();
    case Location::Base: break;
  }
  return feature.known.front();
}

/// Where an arm has one feature by its own readings alone, whatever its artefact says of the others.
struct Measured {
  Eigen::Vector3d point_in_base;  ///< a point or centre; of a plane, the middle of the tips
  double height = 0.0;            ///< of a plane along its group's axis
};

Measured measure(const Tips& tips, const Unknowns& unknowns) {
  const FeatureConstraint& feature = *tips.feature;
  Measured measured{tips.centres.rowwise().mean(), 0.0};
  if (feature.is<OnPlane>() && feature.location == Location::Unknown) {
    const GroupState& group = state_of(feature, unknowns);
    const PlaneAxis axis(group.reference, group.values.data());
    const double side = side_of(feature, group.reference);
    measured.height = axis.direction.dot(measured.point_in_base - axis.origin) - side * tips.radii.mean();
  } else if (feature.has_centre() && feature.location == Location::Unknown && unknowns.shared.size() == 0) {
    measured.point_in_base = certified_point(feature, unknowns);  // estimated from these readings alone
  } else if (feature.has_centre()) {
    // Readings that do not determine a centre leave it where the artefact has it.
    measured.point_in_base = point_at_distances(tips.centres, distances_from_centre(tips, unknowns.shared))
                                 .value_or(certified_point(feature, unknowns));
  }
  return measured;
}

// Variance, per variance of a reading, of a feature's point along a direction: of a centre by the normal equations of
// |P − c| = ρ, which readings on a small cap hardly determine; of a point or a plane by its mean.
double variance_of_point(const Tips& tips, const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
  if (!tips.feature->has_centre()) {
    return 1.0 / tips.feature->size();
  }
  Eigen::Matrix3d normal = Eigen::Matrix3d::Identity() * 1e-9;
  for (int k = 0; k < tips.feature->size(); ++k) {
    const Eigen::Vector3d outward = (tips.centres.col(k) - point).normalized();
    normal += outward * outward.transpose();
  }
  return direction.dot(normal.ldlt().solve(direction));
}

double length_between(const Measured& from, const Measured& to, bool planes) {
  return planes ? std::abs(to.height - from.height) : (to.point_in_base - from.point_in_base).norm();
}

}  // namespace

bool has_signed_deviation(const FeatureConstraint& feature) { return feature.dimension() == 1; }

Expected<Evaluation> evaluate(const Recording& recording, const Constraints& constraints, const Arm& arm) {
  return evaluate(make_system(recording, constraints, arm, {}), recording);
}

Expected<Evaluation> evaluate(const System& system, const Recording& recording) {
  const Constraints& constraints = *system.constraints;
  const Arm& arm = system.start;
  const auto all = all_tips(system, arm);
  const auto unknowns = estimate_nuisance_parameters(system, arm, recording, all);
  if (!unknowns) {
    return tl::unexpected(unknowns.error());
  }
  Evaluation evaluation;
  std::map<std::pair<int, int>, Sum> placements;
  std::map<int, Sum> artefacts;
  Sum overall;
  std::vector<Measured> measured;
  std::vector<Eigen::Vector3d> certified;
  for (const Tips& tips : all) {
    const FeatureConstraint& feature = *tips.feature;
    const GroupState& group = state_of(feature, *unknowns);
    const FeatureResidual residual(feature, group.reference, group.values.data(), unknowns->shared.data());
    Sum sum;
    for (int k = 0; k < feature.size(); ++k) {
      const Eigen::Vector3d tip = tips.centres.col(k);
      const Residual r = residual.at(k, tip, tips.radii[k], true);
      evaluation.deviations.push_back(r.rows == 1 ? r.value[0] : r.value.norm());
      evaluation.tips.push_back(tip);
      evaluation.offsets.push_back(r.by_tip.topRows(r.rows).transpose() * r.value.head(r.rows));
      sum.add(evaluation.deviations.back());
    }
    measured.push_back(measure(tips, *unknowns));
    evaluation.points.push_back(measured.back().point_in_base);
    certified.push_back(feature.has_centre() ? certified_point(feature, *unknowns) : evaluation.points.back());
    evaluation.features.push_back(sum.named(name_of(feature, constraints, recording)));
    placements[{feature.artefact, feature.placement}].add(sum);
    artefacts[feature.artefact].add(sum);
    overall.add(sum);
  }
  choose_sides(constraints, all, *unknowns, certified, evaluation.points);
  for (std::size_t f = 0; f < measured.size(); ++f) {
    measured[f].point_in_base = evaluation.points[f];
  }
  for (const auto& [key, sum] : placements) {
    evaluation.placements.push_back(
        sum.named({constraints.artefacts[key.first].name, recording.placements.name(key.second), ""}));
  }
  for (const auto& [artefact, sum] : artefacts) {
    evaluation.artefacts.push_back(sum.named({constraints.artefacts[artefact].name, "", ""}));
  }
  evaluation.overall = overall.named({});
  for (const auto& distance : constraints.distances) {
    const FeatureConstraint& first = constraints.features[distance.first];
    const FeatureConstraint& second = constraints.features[distance.second];
    const double length = length_between(measured[distance.first], measured[distance.second], first.is<OnPlane>());
    const Eigen::Vector3d along =
        (measured[distance.second].point_in_base - measured[distance.first].point_in_base).normalized();
    double variance = 0.0;
    for (const int end : {distance.first, distance.second}) {
      variance += variance_of_point(all[end], measured[end].point_in_base, along);
    }
    evaluation.lengths.push_back({name_of(first, constraints, recording),
                                  name_of(second, constraints, recording).feature, distance.certified, distance.value,
                                  length - distance.value, distance.u, std::sqrt(variance)});
  }
  return evaluation;
}

Evaluation not_evaluated(Evaluation like) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (auto* deviations : {&like.features, &like.placements, &like.artefacts}) {
    for (FeatureDeviation& deviation : *deviations) {
      deviation.rms = deviation.maximum = none;
    }
  }
  like.overall.rms = like.overall.maximum = none;
  for (LengthDeviation& length : like.lengths) {
    length.error = none;
  }
  like.deviations.assign(like.deviations.size(), none);
  for (auto* vectors : {&like.tips, &like.offsets, &like.points}) {
    vectors->assign(vectors->size(), Eigen::Vector3d::Constant(none));
  }
  return like;
}

}  // namespace artcal
