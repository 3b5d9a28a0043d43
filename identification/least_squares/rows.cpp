#include "identification/least_squares/rows.h"

#include <algorithm>
#include <vector>

namespace artcal {
namespace {

// out(row, ·) = whitening · by_tip · derivative · scale, for the reading's one or three rows.
void put_arm_rows(const Eigen::Matrix3d& tip_to_rows, int rows, const std::vector<double>& derivative,
                  const Eigen::VectorXd& scale, double* out, std::ptrdiff_t stride) {
  for (int row = 0; row < rows; ++row) {
    const double wx = tip_to_rows(row, 0);
    const double wy = tip_to_rows(row, 1);
    const double wz = tip_to_rows(row, 2);
    double* line = out + row * stride;
    const double* d = derivative.data();
    for (Eigen::Index column = 0; column < scale.size(); ++column, d += 3) {
      line[column] = scale[column] * (wx * d[0] + wy * d[1] + wz * d[2]);
    }
  }
}

// The frequent case of an unrotated residual with one weight for all directions: a scaled transpose.
void put_arm_rows(double weight, const std::vector<double>& derivative, const Eigen::VectorXd& scale, double* out,
                  std::ptrdiff_t stride) {
  const double* d = derivative.data();
  for (Eigen::Index column = 0; column < scale.size(); ++column, d += 3) {
    const double w = weight * scale[column];
    out[column] = w * d[0];
    out[column + stride] = w * d[1];
    out[column + 2 * stride] = w * d[2];
  }
}

}  // namespace

void weighted_rows(const System& system, const FeatureConstraint& feature, const FeatureWeights& weights,
                   const std::vector<ForwardKinematics>& kinematics_by_probe, const FeatureResidual& residual,
                   int first, int count, const RowsOut& out) {
  const int rows = feature.dimension();
  const bool derivatives = out.by_arm != nullptr || out.by_group != nullptr || out.by_shared != nullptr;
  const bool plain = weights.matrix.empty() && feature.is<Coincide>() && feature.location != Location::Posed;
  const auto first_error = feature.first_error;
  const auto shared_radius = feature.shared_radius();
  std::vector<double> by_parameters(static_cast<std::size_t>(3 * system.arm_size()));
  for (int i = 0; i < count; ++i) {
    const int k = first + i;
    const int reading = feature.readings[k];
    const ForwardKinematics& kinematics = kinematics_by_probe[system.probes[reading]];
    Eigen::Vector3d tip = out.by_arm != nullptr ? kinematics.tip_in_base(system.sines_of(reading), by_parameters.data())
                                                : kinematics.tip_in_base(system.sines_of(reading));
    if (!system.shifts.empty()) {
      tip += system.shifts[reading];
    }
    const Residual r = residual.at(k, tip, kinematics.tip_radius(), derivatives);
    const Eigen::Matrix3d whitening =
        weights.matrix.empty() ? Eigen::Matrix3d(weights.scalar[k] * Eigen::Matrix3d::Identity()) : weights.matrix[k];
    const std::ptrdiff_t at = i * rows * out.stride;
    const Eigen::Vector3d value = whitening.leftCols(rows) * r.value.head(rows);
    for (int row = 0; row < rows; ++row) {
      out.residuals[at + row * out.stride] = value[row];
    }
    if (out.by_arm != nullptr) {
      if (plain) {
        put_arm_rows(weights.scalar[k], by_parameters, system.scale, out.by_arm + at, out.stride);
      } else {
        Eigen::Matrix3d tip_to_rows = r.by_tip;
        tip_to_rows.topRows(rows) = whitening.topLeftCorner(rows, rows) * r.by_tip.topRows(rows);
        put_arm_rows(tip_to_rows, rows, by_parameters, system.scale, out.by_arm + at, out.stride);
      }
      if (const int column = kinematics.radius_column(); column >= 0 && rows == 1) {
        out.by_arm[at + column] = whitening(0, 0) * r.by_tip_radius * system.scale[column];
      }
    }
    if (out.by_group != nullptr) {
      for (int column = 0; column < residual.columns(); ++column) {
        const Eigen::Vector3d slope = whitening.leftCols(rows) * r.by_unknowns.col(column).head(rows);
        for (int row = 0; row < rows; ++row) {
          out.by_group[at + row * out.stride + residual.column(column)] = slope[row];
        }
      }
    }
    if (out.by_shared != nullptr && first_error) {
      Eigen::Map<RowMatrix, 0, Eigen::OuterStride<>> lines(out.by_shared + at + (*first_error - out.first_shared), rows,
                                                           3, Eigen::OuterStride<>(out.stride));
      lines = whitening.topLeftCorner(rows, rows) * r.by_errors.topRows(rows);
    }
    if (out.by_shared != nullptr && shared_radius) {
      out.by_shared[at + *shared_radius - out.first_shared] = whitening(0, 0) * r.by_ball_radius;
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
