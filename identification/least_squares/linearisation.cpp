#include "identification/least_squares/linearisation.h"

#include <algorithm>
#include <cmath>

#include "identification/least_squares/elimination.h"
#include "identification/least_squares/row_stack.h"
#include "identification/least_squares/rows.h"

namespace artcal {
namespace {

constexpr int readings_at_once = 32;

// Multiplies an observation's rows, whose last column is the residual, by √ρ' and returns Σρ − Σρ'·s, the part of the
// cost that they no longer carry.
double reweight(Loss loss, double expected, Eigen::Ref<RowMatrix> rows) {
  const double squares = rows.rightCols<1>().squaredNorm();
  const LossValue rho = loss_of(loss, squares, expected);
  rows *= std::sqrt(rho.slope);
  return rho.value - squares * rho.slope;
}

// The same for a run of readings of one feature.
double reweight(Loss loss, int dimension, const FeatureWeights& weights, int reading, Eigen::Ref<RowMatrix> rows) {
  double beyond = 0.0;
  for (Eigen::Index first = 0; first < rows.rows(); first += dimension, ++reading) {
    beyond += reweight(loss, expected_square(weights, reading, dimension), rows.middleRows(first, dimension));
  }
  return beyond;
}

}  // namespace

int max_rows(const System& system, Loss loss, const Block& block) {
  int rows = static_cast<int>(block.distances.size()) + (block.has_certificate ? block.parameters.size : 0);
  for (const int f : block.features) {
    const FeatureConstraint& feature = system.constraints->features[f];
    rows += feature.size() * feature.dimension();
  }
  return std::min(rows + (loss == Loss::None ? 0 : 1), block.nuisance() + system.arm_size() + 1);
}

Eigen::MatrixXd block_rows(const System& system, const Weights& weights, Loss loss, const Block& block,
                           const std::vector<ForwardKinematics>& kinematics_by_probe, const BlockPoint& point) {
  const Constraints& constraints = *system.constraints;
  const int before_arm = block.nuisance();
  const int columns = before_arm + system.arm_size() + 1;
  RowStack stack(columns);
  RowMatrix rows(3 * readings_at_once, columns);
  double beyond = 0.0;
  for (const int f : block.features) {
    const FeatureConstraint& feature = constraints.features[f];
    const FeatureResidual residual(feature, point.reference, point.values, point.shared);
    rows.leftCols(before_arm).setZero();  // each feature fills its own columns only
    for (int first = 0; first < feature.size(); first += readings_at_once) {
      const int count = std::min(readings_at_once, feature.size() - first);
      weighted_rows(
          system, feature, weights.features[f], kinematics_by_probe, residual, first, count,
          {columns, rows.data() + columns - 1, rows.data() + before_arm, block.unknowns > 0 ? rows.data() : nullptr,
           block.parameters.size > 0 ? rows.data() + block.unknowns : nullptr, block.parameters.first});
      if (loss != Loss::None) {
        beyond +=
            reweight(loss, feature.dimension(), weights.features[f], first, rows.topRows(count * feature.dimension()));
      }
      stack.add(rows.topRows(count * feature.dimension()));
    }
  }
  RowMatrix row(1, columns);
  for (const int d : block.distances) {
    row.setZero();
    row(0, columns - 1) =
        weighted_distance(constraints.distances[d], constraints, weights.distances[d], point.values, row.data());
    if (loss_reaches_distances(loss, weights)) {
      beyond += reweight(loss, weights.distance_variance[d], row);
    }
    stack.add(row);
  }
  for (int i = 0; block.has_certificate && i < block.parameters.size; ++i) {
    const int s = block.parameters.first + i;
    row.setZero();
    row(0, block.unknowns + i) = weights.shared[s];
    row(0, columns - 1) = weighted_shared(constraints.shared[s], weights.shared[s], point.shared[s]);
    if (loss_reaches_shared(loss, weights)) {
      beyond += reweight(loss, weights.shared_variance[s], row);
    }
    stack.add(row);
  }
  if (loss != Loss::None) {
    row.setZero();
    row(0, columns - 1) = std::sqrt(std::max(0.0, beyond));  // what is below zero is rounding
    stack.add(row);
  }
  return stack.rows();
}

double block_cost(const System& system, const Weights& weights, Loss loss, const Block& block,
                  const std::vector<ForwardKinematics>& kinematics_by_probe, const BlockPoint& point) {
  const Constraints& constraints = *system.constraints;
  double sum = 0.0;
  for (const int f : block.features) {
    const FeatureConstraint& feature = constraints.features[f];
    RowMatrix residuals(feature.size() * feature.dimension(), 1);
    weighted_rows(system, feature, weights.features[f], kinematics_by_probe,
                  FeatureResidual(feature, point.reference, point.values, point.shared), 0, feature.size(),
                  {1, residuals.data()});
    if (loss != Loss::None) {
      sum += reweight(loss, feature.dimension(), weights.features[f], 0, residuals);
    }
    sum += residuals.squaredNorm();
  }
  for (const int d : block.distances) {
    const double residual =
        weighted_distance(constraints.distances[d], constraints, weights.distances[d], point.values, nullptr);
    sum += loss_reaches_distances(loss, weights)
               ? loss_of(loss, residual * residual, weights.distance_variance[d]).value
               : residual * residual;
  }
  for (int s = block.parameters.first; block.has_certificate && s < block.parameters.first + block.parameters.size;
       ++s) {
    const double residual = weighted_shared(constraints.shared[s], weights.shared[s], point.shared[s]);
    sum += loss_reaches_shared(loss, weights) ? loss_of(loss, residual * residual, weights.shared_variance[s]).value
                                              : residual * residual;
  }
  return sum;
}

Linearisation linearise(const System& system, const Weights& weights, Loss loss, const Arm& arm,
                        const Unknowns& unknowns) {
  return linearise(system, weights, loss, blocks_of(*system.constraints), arm, unknowns);
}

Linearisation linearise(const System& system, const Weights& weights, Loss loss, const std::vector<Block>& blocks,
                        const Arm& arm, const Unknowns& unknowns) {
  const auto kinematics_by_probe = forward_kinematics_of(system, arm);
  const GroupState none;
  Linearisation result;
  result.layout = layout_of(*system.constraints, system.arm_size());
  for (const Block& block : blocks) {
    const GroupState& group = block.group < 0 ? none : unknowns.groups[block.group];
    result.blocks.push_back({block.group, block.unknowns, block.parameters,
                             block_rows(system, weights, loss, block, kinematics_by_probe,
                                        {group.reference, group.values.data(), unknowns.shared.data()})});
  }
  return result;
}

Eigen::MatrixXd arm_triangle(const Linearisation& linearisation, int arm_size) {
  return eliminate_nuisance(linearisation, arm_size);
}

}  // namespace artcal
