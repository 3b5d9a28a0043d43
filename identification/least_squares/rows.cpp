#include "identification/least_squares/rows.h"

#include <algorithm>
#include <vector>

#include "identification/least_squares/kernels/ball_rows.h"
#include "identification/problem/posture_batch.h"

namespace artcal {
namespace {

// From one coordinate of a derivative to the next, and from one column to the next (ForwardKinematics::tips_in_base()).
constexpr int coordinate_stride = postures_at_once;
constexpr int column_stride = 3 * coordinate_stride;

// out(row, ·) = whitening · by_tip · derivative · scale, for the reading's one or three rows.
void put_arm_rows(const Eigen::Matrix3d& tip_to_rows, int rows, const double* derivative, const Eigen::VectorXd& scale,
                  double* out, std::ptrdiff_t stride) {
  for (int row = 0; row < rows; ++row) {
    const double wx = tip_to_rows(row, 0);
    const double wy = tip_to_rows(row, 1);
    const double wz = tip_to_rows(row, 2);
    double* line = out + row * stride;
    const double* d = derivative;
    for (Eigen::Index column = 0; column < scale.size(); ++column, d += column_stride) {
      line[column] = scale[column] * (wx * d[0] + wy * d[coordinate_stride] + wz * d[2 * coordinate_stride]);
    }
  }
}

// The frequent case of an unrotated residual with one weight for all directions: a scaled transpose.
void put_arm_rows(double weight, const double* derivative, const Eigen::VectorXd& scale, double* out,
                  std::ptrdiff_t stride) {
  const double* d = derivative;
  for (Eigen::Index column = 0; column < scale.size(); ++column, d += column_stride) {
    const double w = weight * scale[column];
    out[column] = w * d[0];
    out[column + stride] = w * d[coordinate_stride];
    out[column + 2 * stride] = w * d[2 * coordinate_stride];
  }
}

// Memory of this thread for derivatives; whoever asks for it next gets the same. What stands in it means nothing.
double* memory_for_derivatives(int columns) {
  thread_local std::vector<double> memory;
  const auto size = static_cast<std::size_t>(column_stride * std::max(1, columns));
  if (memory.size() < size) {
    memory.resize(size);
  }
  return memory.data();
}

/// The tips of a feature's readings and their derivatives, in the order of the readings, eight at a time. One at a time
/// on a thread.
class TipsOf {
 public:
  TipsOf(const System& system, const FeatureConstraint& feature,
         const std::vector<ForwardKinematics>& kinematics_by_probe, bool derivatives)
      : system_(system),
        feature_(feature),
        kinematics_by_probe_(kinematics_by_probe),
        derivatives_(derivatives ? memory_for_derivatives(system.arm_size()) : nullptr) {}

  /// Moves to reading `k` of those before `end`.
  void take(int k, int end) {
    if (k >= first_ + count_ || k < first_) {
      fill(k, end);
    }
    lane_ = k - first_;
  }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] const double* tips() const { return tips_; }
  [[nodiscard]] Eigen::Vector3d tip() const {
    return {tips_[lane_], tips_[lane_ + coordinate_stride], tips_[lane_ + 2 * coordinate_stride]};
  }
  [[nodiscard]] const double* derivative() const { return derivatives_ + lane_; }

 private:
  void fill(int k, int end) {
    const PostureBatch taken = posture_batch(system_, feature_, k, end);
    first_ = k;
    count_ = taken.count;
    kinematics_by_probe_[system_.probes[feature_.readings[k]]].tips_in_base(
        {taken.readings.data(), static_cast<std::size_t>(count_)}, tips_, derivatives_);
  }

  const System& system_;
  const FeatureConstraint& feature_;
  const std::vector<ForwardKinematics>& kinematics_by_probe_;
  double* derivatives_;
  alignas(64) double tips_[column_stride];
  int first_ = 0, count_ = 0, lane_ = 0;
};

// Readings on a ball, or at known distances from a point, that is unknown, each with one weight.
bool suits_ball_rows(const System& system, const FeatureConstraint& feature, const FeatureWeights& weights) {
  return feature.location == Location::Unknown && !feature.first_error && weights.matrix.empty() &&
         system.shifts.empty() && feature.has_centre();
}

void put_ball_rows(const System& system, const FeatureConstraint& feature, const FeatureWeights& weights,
                   const std::vector<ForwardKinematics>& kinematics_by_probe, const FeatureResidual& residual,
                   int first, int count, const RowsOut& out) {
  BallRows* put = ball_rows_variants().back().put;
  const auto* at_distance = feature.as<AtDistance>();
  const auto shared_radius = feature.shared_radius();
  const Eigen::Vector3d& centre = residual.point_in_base();
  TipsOf tips(system, feature, kinematics_by_probe, out.by_arm != nullptr);
  BallReadings readings{tips.tips(), nullptr, system.arm_size(), {centre.x(), centre.y(), centre.z()}, {}, {}};
  for (int i = 0; i < count; i += tips.count()) {
    const int k = first + i;
    tips.take(k, first + count);
    const ForwardKinematics& kinematics = kinematics_by_probe[system.probes[feature.readings[k]]];
    for (int lane = 0; lane < tips.count(); ++lane) {
      readings.lengths[lane] =
          at_distance == nullptr ? residual.ball_radius() + kinematics.tip_radius() : at_distance->distances[k + lane];
      readings.weights[lane] = weights.scalar[k + lane];
    }
    readings.derivative = tips.derivative();
    const std::ptrdiff_t at = i * out.stride;
    put(readings, system.scale.data(), tips.count(), out.stride, out.residuals + at,
        out.by_group != nullptr ? out.by_group + at + residual.column(0) : nullptr,
        out.by_arm != nullptr ? out.by_arm + at : nullptr);
    for (int lane = 0; lane < tips.count(); ++lane) {
      const std::ptrdiff_t row = at + lane * out.stride;
      if (const int column = kinematics.radius_column(); column >= 0 && out.by_arm != nullptr) {
        out.by_arm[row + column] =
            readings.weights[lane] * (at_distance == nullptr ? -1.0 : 0.0) * system.scale[column];
      }
      if (out.by_shared != nullptr && shared_radius) {
        out.by_shared[row + *shared_radius - out.first_shared] = readings.weights[lane] * -feature.expansion;
      }
    }
  }
}

}  // namespace

void weighted_rows(const System& system, const FeatureConstraint& feature, const FeatureWeights& weights,
                   const std::vector<ForwardKinematics>& kinematics_by_probe, const FeatureResidual& residual,
                   int first, int count, const RowsOut& out) {
  if (suits_ball_rows(system, feature, weights)) {
    put_ball_rows(system, feature, weights, kinematics_by_probe, residual, first, count, out);
    return;
  }
  const int rows = feature.dimension();
  const bool derivatives = out.by_arm != nullptr || out.by_group != nullptr || out.by_shared != nullptr;
  const bool plain = weights.matrix.empty() && feature.is<Coincide>() && feature.location != Location::Posed;
  const auto first_error = feature.first_error;
  const auto shared_radius = feature.shared_radius();
  TipsOf tips(system, feature, kinematics_by_probe, out.by_arm != nullptr);
  for (int i = 0; i < count; ++i) {
    const int k = first + i;
    const int reading = feature.readings[k];
    const ForwardKinematics& kinematics = kinematics_by_probe[system.probes[reading]];
    tips.take(k, first + count);
    Eigen::Vector3d tip = tips.tip();
    if (!system.shifts.empty()) {
      tip += system.shifts[reading];
    }
    const Residual r = residual.at(k, tip, kinematics.tip_radius(), derivatives);
    // One weight for all directions scales what a matrix turns.
    const Eigen::Matrix3d* whitening = weights.matrix.empty() ? nullptr : &weights.matrix[k];
    const double weight = whitening == nullptr ? weights.scalar[k] : (*whitening)(0, 0);
    const std::ptrdiff_t at = i * rows * out.stride;
    const auto put = [&](double* to, const auto& values) {
      for (int row = 0; row < rows; ++row) {
        to[row * out.stride] = values[row];
      }
    };
    const auto put_whitened = [&](double* to, const auto& values) {
      if (whitening == nullptr) {
        put(to, weight * values);
      } else {
        put(to, Eigen::Vector3d(whitening->leftCols(rows) * values.head(rows)));
      }
    };
    put_whitened(out.residuals + at, r.value);
    if (out.by_arm != nullptr) {
      if (plain) {
        put_arm_rows(weight, tips.derivative(), system.scale, out.by_arm + at, out.stride);
      } else {
        Eigen::Matrix3d tip_to_rows = r.by_tip;
        if (whitening == nullptr) {
          tip_to_rows.topRows(rows) *= weight;
        } else {
          tip_to_rows.topRows(rows) = whitening->topLeftCorner(rows, rows) * r.by_tip.topRows(rows);
        }
        put_arm_rows(tip_to_rows, rows, tips.derivative(), system.scale, out.by_arm + at, out.stride);
      }
      if (const int column = kinematics.radius_column(); column >= 0 && rows == 1) {
        out.by_arm[at + column] = weight * r.by_tip_radius * system.scale[column];
      }
    }
    if (out.by_group != nullptr) {
      for (int column = 0; column < residual.columns(); ++column) {
        put_whitened(out.by_group + at + residual.column(column), r.by_unknowns.col(column));
      }
    }
    if (out.by_shared != nullptr && first_error) {
      Eigen::Map<RowMatrix, 0, Eigen::OuterStride<>> lines(out.by_shared + at + (*first_error - out.first_shared), rows,
                                                           3, Eigen::OuterStride<>(out.stride));
      if (whitening == nullptr) {
        lines = weight * r.by_errors.topRows(rows);
      } else {
        lines = whitening->topLeftCorner(rows, rows) * r.by_errors.topRows(rows);
      }
    }
    if (out.by_shared != nullptr && shared_radius) {
      out.by_shared[at + *shared_radius - out.first_shared] = weight * r.by_ball_radius;
    }
  }
}

RowsOut BlockColumns::out(double* row) const {
  return {all(),
          row + residual(),
          row + nuisance(),
          unknowns > 0 ? row : nullptr,
          parameters.size > 0 ? row + unknowns : nullptr,
          parameters.first};
}

BlockPoint point_of(const Block& block, const Unknowns& unknowns) {
  static const GroupState none;
  const GroupState& group = block.group < 0 ? none : unknowns.groups[block.group];
  return {group.reference, group.values.data(), unknowns.shared.data()};
}

double weighted_distance(const DistanceConstraint& distance, const Constraints& constraints, double weight,
                         const double* group_values, double* by_group) {
  const FeatureConstraint& first = constraints.features[distance.first];
  const FeatureConstraint& second = constraints.features[distance.second];
  if (by_group != nullptr) {
    std::fill_n(by_group, constraints.groups[*first.group].size, 0.0);
  }
  if (first.is<OnPlane>()) {
    const double apart = group_values[second.offset] - group_values[first.offset];
    const double sign = apart < 0.0 ? -1.0 : 1.0;
    if (by_group != nullptr) {
      by_group[second.offset] = weight * sign;
      by_group[first.offset] = -weight * sign;
    }
    return weight * (sign * apart - distance.value);
  }
  const Eigen::Vector3d apart =
      Eigen::Vector3d::Map(group_values + second.offset) - Eigen::Vector3d::Map(group_values + first.offset);
  const double length = apart.norm();
  if (by_group != nullptr) {
    const Eigen::Vector3d direction = length > 0.0 ? Eigen::Vector3d(apart / length) : Eigen::Vector3d::UnitX();
    Eigen::Vector3d::Map(by_group + second.offset) = weight * direction;
    Eigen::Vector3d::Map(by_group + first.offset) = -weight * direction;
  }
  return weight * (length - distance.value);
}

}  // namespace artcal
