#include "identification/planning/session_information.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "acquisition/arm/forward_kinematics.h"
#include "artefacts/virtual_probing/postures.h"
#include "core/cross_matrix.h"
#include "core/random.h"
#include "fitting/fit.h"
#include "identification/identifiability/svd.h"
#include "identification/least_squares/triangular_factor.h"
#include "identification/planning/design_pool.h"

namespace artcal {
namespace {

constexpr double rounding = 1e-4;  // mm: no row weighs more than a value that is certain to this
constexpr int length_count = 200;
constexpr std::size_t touches_of_ball = 4;
constexpr std::size_t touches_of_plane = 3;

/// A tip and its derivatives.
struct TipRows {
  Eigen::Vector3d at;
  Eigen::Matrix3Xd by_parameters;  // physical units
  Eigen::Matrix3Xd by_joints;
};

TipRows tip_rows(const Arm& arm, const std::vector<Parameter>& parameters, const Eigen::VectorXd& scale, int probe,
                 const Eigen::VectorXd& q) {
  const std::span<const double> joints(q.data(), static_cast<std::size_t>(q.size()));
  std::vector<double> sines(2 * joints.size());
  joint_sines(joints, sines);
  const ForwardKinematics kinematics(arm, parameters, probe);
  TipRows rows{Eigen::Vector3d::Zero(), Eigen::Matrix3Xd(3, scale.size()), Eigen::Matrix3Xd(3, q.size())};
  rows.at = kinematics.tip_in_base({sines, joints}, rows.by_parameters.data());
  (void)kinematics.tip_by_joints({sines, joints}, rows.by_joints.data());
  rows.by_parameters = rows.by_parameters * scale.asDiagonal();
  return rows;
}

// Two directions across a normal, as columns.
Eigen::Matrix<double, 3, 2> across(const Eigen::Vector3d& normal) {
  Eigen::Matrix<double, 3, 2> directions;
  directions.col(0) = normal.unitOrthogonal();
  directions.col(1) = normal.cross(directions.col(0));
  return directions;
}

bool is_posed(const Artefact& artefact) {
  return std::any_of(artefact.features.begin(), artefact.features.end(),
                     [](const auto& f) { return f.at.has_value(); });
}

}  // namespace

SessionInformation::SessionInformation(const Arm& nominal, std::vector<Artefact> artefacts, double encoder,
                                       double probing, std::uint64_t seed)
    : arm_(nominal),
      artefacts_(std::move(artefacts)),
      encoder_(encoder),
      probing_(probing),
      parameters_(parameters_of(nominal)) {
  scale_.resize(parameters());
  const double length = reach(arm_);
  std::transform(parameters_.begin(), parameters_.end(), scale_.data(),
                 [&](const Parameter& parameter) { return physical_scale(parameter, length); });
  for (std::size_t a = 0; a < artefacts_.size(); ++a) {
    for (std::size_t d = 0; d < artefacts_[a].distances.size(); ++d) {
      if (artefacts_[a].distances[d].u > 0.0) {
        error_of_[{static_cast<int>(a), static_cast<int>(d)}] = errors_++;
      }
    }
  }
  RandomStream random(seed, "lengths of a session");
  lengths_ = Eigen::MatrixXd::Zero(common(), length_count);
  length_noise_.resize(length_count);
  for (int i = 0; i < length_count; ++i) {
    const TipRows first = tip_rows(arm_, parameters_, scale_, 0, random_posture(arm_, random));
    const TipRows second = tip_rows(arm_, parameters_, scale_, 0, random_posture(arm_, random));
    const Eigen::Vector3d along = (second.at - first.at).normalized();
    lengths_.col(i).tail(parameters()) = (second.by_parameters - first.by_parameters).transpose() * along;
    length_noise_[i] = 2.0 * probing_ * probing_ + encoder_ * encoder_ *
                                                       ((first.by_joints.transpose() * along).squaredNorm() +
                                                        (second.by_joints.transpose() * along).squaredNorm());
  }
}

// Of each feature three of its place and one of a radius that nobody certifies; then six of a pose.
Eigen::Index SessionInformation::first_column(int artefact, int feature) const {
  Eigen::Index first = 0;
  for (int f = 0; f < feature; ++f) {
    const CertifiedFeature& before =
        artefacts_[static_cast<std::size_t>(artefact)].features[static_cast<std::size_t>(f)];
    first += before.kind == FeatureKind::Sphere && !before.radius ? 4 : 3;
  }
  return first;
}

Eigen::Index SessionInformation::own_columns(int artefact) const {
  const Artefact& of = artefacts_[static_cast<std::size_t>(artefact)];
  return first_column(artefact, static_cast<int>(of.features.size())) + (is_posed(of) ? 6 : 0);
}

void SessionInformation::locate(const SessionReading& reading, Place& place) const {
  const CertifiedFeature& feature =
      artefacts_[static_cast<std::size_t>(reading.artefact)].features[static_cast<std::size_t>(reading.feature)];
  Eigen::Matrix3Xd tips(3, static_cast<Eigen::Index>(place.waiting.size()));
  for (Eigen::Index i = 0; i < tips.cols(); ++i) {
    const SessionReading& touch = place.waiting[static_cast<std::size_t>(i)];
    tips.col(i) = tip_at(arm_, touch.probe, touch.joints);
  }
  if (feature.kind == FeatureKind::Sphere && place.waiting.size() >= touches_of_ball) {
    FitOptions options;
    options.fixed_radius = feature.radius;
    options.tip_radius = arm_.probes[static_cast<std::size_t>(reading.probe)].radius;
    if (const auto ball = fit<Sphere>(tips, options)) {
      place.at = ball->feature.centre;
      place.is_known = true;
    }
  } else if (feature.kind == FeatureKind::Plane && place.waiting.size() >= touches_of_plane) {
    if (const auto plane = fit<Plane>(tips)) {
      place.at = plane->feature.point;
      place.normal = plane->feature.normal;
      place.spread = std::max(1.0, (tips.colwise() - place.at).colwise().norm().maxCoeff());
      place.is_known = true;
    }
  } else if (feature.kind == FeatureKind::Point) {
    place.at = tips.col(0);
    place.is_known = true;
  }
}

void SessionInformation::fold(const SessionReading& reading, const Place& place, Placement& placement) const {
  const CertifiedFeature& feature =
      artefacts_[static_cast<std::size_t>(reading.artefact)].features[static_cast<std::size_t>(reading.feature)];
  const TipRows tip = tip_rows(arm_, parameters_, scale_, reading.probe, reading.joints);
  const Eigen::Matrix3d covariance = probing_ * probing_ * Eigen::Matrix3d::Identity() +
                                     encoder_ * encoder_ * tip.by_joints * tip.by_joints.transpose();
  const Eigen::Index own = own_columns(reading.artefact);
  const Eigen::Index first = first_column(reading.artefact, reading.feature);
  if (feature.kind == FeatureKind::Point) {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3, own + common());
    rows.middleCols(first, 3) = -Eigen::Matrix3d::Identity();
    rows.rightCols(parameters()) = tip.by_parameters;
    fold_rows(covariance.llt().matrixL().solve(rows), placement);
    return;
  }
  const bool is_plane = feature.kind == FeatureKind::Plane;
  const Eigen::Vector3d from_place = tip.at - place.at;
  const Eigen::Vector3d normal = is_plane ? place.normal : from_place.normalized();
  Eigen::MatrixXd row = Eigen::MatrixXd::Zero(1, own + common());
  if (is_plane) {
    row(0, first) = -1.0;
    row.block<1, 2>(0, first + 1) = from_place.transpose() * across(normal) / place.spread;
  } else {
    row.block<1, 3>(0, first) = -normal.transpose();
    if (!feature.radius) {
      row(0, first + 3) = -1.0;
    }
  }
  row.rightCols(parameters()) = normal.transpose() * tip.by_parameters;
  fold_rows(row / std::sqrt(normal.dot(covariance * normal)), placement);
}

// What the certificate says of a feature whose place has become known, with those that are known already.
void SessionInformation::fold_certified(const SessionReading& reading, Placement& placement) const {
  const Artefact& artefact = artefacts_[static_cast<std::size_t>(reading.artefact)];
  const Place& place = placement.places.at(reading.feature);
  const Eigen::Index own = own_columns(reading.artefact);
  for (std::size_t d = 0; d < artefact.distances.size(); ++d) {
    const CertifiedDistance& distance = artefact.distances[d];
    const int other = distance.first == reading.feature    ? distance.second
                      : distance.second == reading.feature ? distance.first
                                                           : -1;
    const auto end = placement.places.find(other);
    if (end == placement.places.end() || !end->second.is_known || place.normal.norm() > 0.0) {
      continue;
    }
    const Eigen::Vector3d along = (place.at - end->second.at).normalized();
    Eigen::MatrixXd row = Eigen::MatrixXd::Zero(1, own + common());
    row.block<1, 3>(0, first_column(reading.artefact, reading.feature)) = along.transpose();
    row.block<1, 3>(0, first_column(reading.artefact, other)) = -along.transpose();
    if (const auto error = error_of_.find({reading.artefact, static_cast<int>(d)}); error != error_of_.end()) {
      row(0, own + error->second) = -distance.u;
    }
    fold_rows(row / rounding, placement);
  }
  const CertifiedFeature& feature = artefact.features[static_cast<std::size_t>(reading.feature)];
  if (feature.at && feature.kind != FeatureKind::Plane) {
    // A small motion of the artefact: δt + δω × r.
    placement.pose_origin = placement.pose_origin.value_or(place.at);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3, own + common());
    rows.middleCols(first_column(reading.artefact, reading.feature), 3) = Eigen::Matrix3d::Identity();
    rows.middleCols(own - 6, 3) = cross_matrix(place.at - *placement.pose_origin) / reach(arm_);
    rows.middleCols(own - 3, 3) = -Eigen::Matrix3d::Identity();
    fold_rows(rows / std::max(rounding, feature.u_at), placement);
  }
}

void SessionInformation::fold_rows(const Eigen::MatrixXd& rows, Placement& placement) const {
  TriangularFactor factor(static_cast<int>(rows.cols()));
  if (placement.triangle.size() > 0) {
    factor.add(placement.triangle);
  }
  factor.add(rows);
  placement.triangle = factor.triangle();
}

Eigen::MatrixXd SessionInformation::eliminated(const Key& key, const Placement& placement) const {
  return placement.triangle.size() == 0
             ? Eigen::MatrixXd(Eigen::MatrixXd::Zero(0, common()))
             : eliminate_leading(placement.triangle, static_cast<int>(own_columns(key.first)));
}

void SessionInformation::turn_to(const Key& key) {
  if (has_current_ && key == current_) {
    return;
  }
  if (has_current_) {
    placements_[current_].of_common = eliminated(current_, placements_[current_]);
  }
  current_ = key;
  has_current_ = true;
  Eigen::VectorXd known = Eigen::VectorXd::Constant(common(), 1.0 / known_beforehand);
  known.head(errors_).setOnes();
  TriangularFactor factor(static_cast<int>(common()));
  factor.add(Eigen::MatrixXd(known.asDiagonal()));
  for (const auto& [other, placement] : placements_) {
    if (other != key && placement.of_common.rows() > 0) {
      factor.add(placement.of_common);
    }
  }
  others_ = factor.triangle();
}

void SessionInformation::add(const SessionReading& reading) {
  const Key key{reading.artefact, reading.placement};
  turn_to(key);
  Placement& placement = placements_[key];
  Place& place = placement.places[reading.feature];
  if (place.is_known) {
    fold(reading, place, placement);
    return;
  }
  place.waiting.push_back(reading);
  locate(reading, place);
  if (place.is_known) {
    for (const SessionReading& touch : place.waiting) {
      fold(touch, place, placement);
    }
    place.waiting.clear();
    fold_certified(reading, placement);
  }
}

Eigen::MatrixXd SessionInformation::information() const {
  TriangularFactor factor(static_cast<int>(common()));
  factor.add(others_);
  if (const auto current = placements_.find(current_); current != placements_.end()) {
    const Eigen::MatrixXd more = eliminated(current_, current->second);
    if (more.rows() > 0) {
      factor.add(more);
    }
  }
  return factor.triangle();
}

int SessionInformation::rank() const {
  if (!has_current_) {
    return 0;
  }
  const Eigen::MatrixXd of_arm = information().bottomRightCorner(parameters(), parameters());
  const Eigen::VectorXd values = svd(of_arm).values;
  const double limit = 2.0 / known_beforehand;  // what is known beforehand alone gives half of it
  return static_cast<int>((values.array() > limit).count());
}

PredictedU SessionInformation::u_of_length() const {
  if (!has_current_) {
    return {known_beforehand, known_beforehand};
  }
  const Eigen::MatrixXd solved = information().transpose().triangularView<Eigen::Lower>().solve(lengths_);
  const Eigen::VectorXd variances = solved.colwise().squaredNorm().transpose() + length_noise_;
  return {std::sqrt(variances.maxCoeff()), std::sqrt(variances.mean())};
}

}  // namespace artcal
