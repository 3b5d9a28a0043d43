#include "identification/least_squares/linearisation.h"

#include <algorithm>
#include <cmath>

#include "core/overloaded.h"
#include "identification/least_squares/elimination.h"

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

namespace {

int rows_of(const System& system, Loss loss, const Block& block) {
  int rows = static_cast<int>(block.distances.size()) + (block.has_certificate ? block.parameters.size : 0);
  for (const int f : block.features) {
    const FeatureConstraint& feature = system.constraints->features[f];
    rows += feature.size() * feature.dimension();
  }
  return rows + (loss == Loss::None ? 0 : 1);
}

}  // namespace

int max_rows(const System& system, Loss loss, const Block& block) {
  return std::min(rows_of(system, loss, block), BlockColumns(block, system).all());
}

Eigen::MatrixXd block_rows(const System& system, const Weights& weights, Loss loss, const Block& block,
                           const std::vector<ForwardKinematics>& kinematics_by_probe, const BlockPoint& point,
                           Folding folding) {
  const Constraints& constraints = *system.constraints;
  const BlockColumns columns(block, system);
  RowStack stack(columns.all(), folding, rows_of(system, loss, block));
  RowMatrix rows(3 * readings_at_once, columns.all());
  RowMatrix row(1, columns.all());
  double beyond = 0.0;
  for_each_observation(
      constraints, block, point,
      Overloaded{[&](const FeatureReadings& readings) {
                   const auto& [f, feature, residual] = readings;
                   rows.leftCols(columns.nuisance()).setZero();  // each feature fills its own columns only
                   for (int first = 0; first < feature.size(); first += readings_at_once) {
                     const int count = std::min(readings_at_once, feature.size() - first);
                     weighted_rows(system, feature, weights.features[f], kinematics_by_probe, residual, first, count,
                                   columns.out(rows.data()));
                     if (loss != Loss::None) {
                       beyond += reweight(loss, feature.dimension(), weights.features[f], first,
                                          rows.topRows(count * feature.dimension()));
                     }
                     stack.add(rows.topRows(count * feature.dimension()));
                   }
                 },
                 [&](const BindingDistance& distance) {
                   row.setZero();
                   row(0, columns.residual()) = weighted_distance(
                       distance.distance, constraints, weights.distances[distance.index], point.values, row.data());
                   if (loss_reaches_distances(loss, weights)) {
                     beyond += reweight(loss, weights.distance_variance[distance.index], row);
                   }
                   stack.add(row);
                 },
                 [&](const CertifiedParameter& certified) {
                   const double weight = weights.shared[certified.index];
                   row.setZero();
                   row(0, columns.unknowns + certified.column) = weight;
                   row(0, columns.residual()) =
                       weighted_shared(certified.parameter, weight, point.shared[certified.index]);
                   if (loss_reaches_shared(loss, weights)) {
                     beyond += reweight(loss, weights.shared_variance[certified.index], row);
                   }
                   stack.add(row);
                 }});
  if (loss != Loss::None) {
    row.setZero();
    row(0, columns.residual()) = std::sqrt(std::max(0.0, beyond));  // what is below zero is rounding
    stack.add(row);
  }
  return stack.rows();
}

double block_cost(const System& system, const Weights& weights, Loss loss, const Block& block,
                  const std::vector<ForwardKinematics>& kinematics_by_probe, const BlockPoint& point) {
  const Constraints& constraints = *system.constraints;
  double sum = 0.0;
  const auto add = [&](double residual, bool is_reached, double expected) {
    sum += is_reached ? loss_of(loss, residual * residual, expected).value : residual * residual;
  };
  for_each_observation(constraints, block, point,
                       Overloaded{[&](const FeatureReadings& readings) {
                                    const auto& [f, feature, residual] = readings;
                                    RowMatrix residuals(feature.size() * feature.dimension(), 1);
                                    weighted_rows(system, feature, weights.features[f], kinematics_by_probe, residual,
                                                  0, feature.size(), {1, residuals.data()});
                                    if (loss != Loss::None) {
                                      sum += reweight(loss, feature.dimension(), weights.features[f], 0, residuals);
                                    }
                                    sum += residuals.squaredNorm();
                                  },
                                  [&](const BindingDistance& distance) {
                                    const bool is_reached = loss_reaches_distances(loss, weights);
                                    add(weighted_distance(distance.distance, constraints,
                                                          weights.distances[distance.index], point.values, nullptr),
                                        is_reached, is_reached ? weights.distance_variance[distance.index] : 1.0);
                                  },
                                  [&](const CertifiedParameter& certified) {
                                    const bool is_reached = loss_reaches_shared(loss, weights);
                                    add(weighted_shared(certified.parameter, weights.shared[certified.index],
                                                        point.shared[certified.index]),
                                        is_reached, is_reached ? weights.shared_variance[certified.index] : 1.0);
                                  }});
  return sum;
}

Linearisation linearise(const System& system, const Weights& weights, Loss loss, const Arm& arm,
                        const Unknowns& unknowns) {
  return linearise(system, weights, loss, blocks_of(*system.constraints), arm, unknowns);
}

Linearisation linearise(const System& system, const Weights& weights, Loss loss, const std::vector<Block>& blocks,
                        const Arm& arm, const Unknowns& unknowns) {
  return linearise(system, weights, loss, blocks, arm, unknowns, Folding::Reflections);
}

Linearisation linearise(const System& system, const Weights& weights, Loss loss, const std::vector<Block>& blocks,
                        const Arm& arm, const Unknowns& unknowns, Folding folding) {
  const auto kinematics_by_probe = forward_kinematics_of(system, arm);
  Linearisation result;
  result.layout = layout_of(*system.constraints, system.arm_size());
  for (const Block& block : blocks) {
    result.blocks.push_back(
        {block.group, block.unknowns, block.parameters,
         block_rows(system, weights, loss, block, kinematics_by_probe, point_of(block, unknowns), folding)});
  }
  return result;
}

Eigen::MatrixXd arm_triangle(const Linearisation& linearisation, int arm_size) {
  return eliminate_nuisance(linearisation, arm_size);
}

}  // namespace artcal
