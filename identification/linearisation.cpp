#include "identification/linearisation.h"

#include <algorithm>
#include <cmath>

#include "identification/rows.h"
#include "identification/triangular_factor.h"

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

std::vector<Block> blocks_of(const Constraints& constraints) {
  std::vector<Block> blocks(constraints.groups.size() + 1);
  for (std::size_t g = 0; g < constraints.groups.size(); ++g) {
    blocks[g + 1].unknowns = constraints.groups[g].size;
  }
  for (int f = 0; f < static_cast<int>(constraints.features.size()); ++f) {
    blocks[constraints.features[f].group + 1].features.push_back(f);
  }
  for (int d = 0; d < static_cast<int>(constraints.distances.size()); ++d) {
    const DistanceConstraint& distance = constraints.distances[d];
    if (distance.binds) {
      blocks[constraints.features[distance.first].group + 1].distances.push_back(d);
    }
  }
  blocks.front().has_shared = !constraints.shared.empty();
  return blocks;
}

Eigen::MatrixXd block_triangle(const System& system, const Weights& weights, Loss loss, const Block& block,
                               const std::vector<Sweep>& sweeps, const BlockPoint& point) {
  const Constraints& constraints = *system.constraints;
  const int before_arm = block.unknowns + system.shared_size();
  const int columns = before_arm + system.arm_size() + 1;
  TriangularFactor factor(columns);
  RowMatrix rows(3 * readings_at_once, columns);
  double beyond = 0.0;
  for (const int f : block.features) {
    const FeatureConstraint& feature = constraints.features[f];
    const FeatureResidual residual(feature, point.reference, point.values, point.shared);
    rows.leftCols(before_arm).setZero();  // each feature fills its own columns only
    for (int first = 0; first < feature.size(); first += readings_at_once) {
      const int count = std::min(readings_at_once, feature.size() - first);
      weighted_rows(
          system, feature, weights.features[f], sweeps, residual, first, count,
          {columns, rows.data() + columns - 1, rows.data() + before_arm, block.unknowns > 0 ? rows.data() : nullptr,
           system.shared_size() > 0 ? rows.data() + block.unknowns : nullptr});
      if (loss != Loss::None) {
        beyond +=
            reweight(loss, feature.dimension(), weights.features[f], first, rows.topRows(count * feature.dimension()));
      }
      factor.add(rows.data(), count * feature.dimension());
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
    factor.add(row.data(), 1);
  }
  for (int s = 0; block.has_shared && s < system.shared_size(); ++s) {
    row.setZero();
    row(0, block.unknowns + s) = weights.shared[s];
    row(0, columns - 1) = weighted_shared(constraints.shared[s], weights.shared[s], point.shared[s]);
    if (loss_reaches_shared(loss, weights)) {
      beyond += reweight(loss, weights.shared_variance[s], row);
    }
    factor.add(row.data(), 1);
  }
  Eigen::MatrixXd triangle = factor.triangle();
  double& rest = triangle(columns - 1, columns - 1);
  rest = std::sqrt(std::max(0.0, rest * rest + beyond));  // what a loss takes off may be rounding
  return triangle;
}

double block_cost(const System& system, const Weights& weights, Loss loss, const Block& block,
                  const std::vector<Sweep>& sweeps, const BlockPoint& point) {
  const Constraints& constraints = *system.constraints;
  double sum = 0.0;
  for (const int f : block.features) {
    const FeatureConstraint& feature = constraints.features[f];
    RowMatrix residuals(feature.size() * feature.dimension(), 1);
    weighted_rows(system, feature, weights.features[f], sweeps,
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
  for (int s = 0; block.has_shared && s < system.shared_size(); ++s) {
    const double residual = weighted_shared(constraints.shared[s], weights.shared[s], point.shared[s]);
    sum += loss_reaches_shared(loss, weights) ? loss_of(loss, residual * residual, weights.shared_variance[s]).value
                                              : residual * residual;
  }
  return sum;
}

Linearisation linearise(const System& system, const Weights& weights, Loss loss, const Arm& arm,
                        const Unknowns& unknowns) {
  const auto sweeps = sweeps_of(system, arm);
  const auto blocks = blocks_of(*system.constraints);
  Linearisation result;
  result.shared = system.shared_size();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const GroupState none;
    const GroupState& group = b == 0 ? none : unknowns.groups[b - 1];
    result.triangles.push_back(block_triangle(system, weights, loss, blocks[b], sweeps,
                                              {group.reference, group.values.data(), unknowns.shared.data()}));
  }
  return result;
}

Eigen::MatrixXd common_triangle(const Linearisation& linearisation, int arm_size) {
  const int common = linearisation.shared + arm_size;
  TriangularFactor factor(common);
  for (const Eigen::MatrixXd& triangle : linearisation.triangles) {
    const auto unknowns = static_cast<int>(triangle.cols()) - 1 - common;
    factor.add(eliminate_leading(triangle.topLeftCorner(unknowns + common, unknowns + common), unknowns));
  }
  return factor.triangle();
}

Eigen::MatrixXd arm_triangle(const Linearisation& linearisation, int arm_size) {
  return eliminate_leading(common_triangle(linearisation, arm_size), linearisation.shared);
}

Linearisation with_parameters(const Linearisation& linearisation, int arm_size, const std::vector<int>& kept) {
  Linearisation result;
  result.shared = linearisation.shared;
  for (const Eigen::MatrixXd& triangle : linearisation.triangles) {
    const Eigen::Index unknowns = triangle.cols() - 1 - arm_size;
    const auto size = static_cast<Eigen::Index>(kept.size());
    Eigen::MatrixXd chosen(triangle.rows(), unknowns + size + 1);
    chosen.leftCols(unknowns) = triangle.leftCols(unknowns);
    for (Eigen::Index i = 0; i < size; ++i) {
      chosen.col(unknowns + i) = triangle.col(unknowns + kept[i]);
    }
    chosen.rightCols<1>() = triangle.rightCols<1>();
    TriangularFactor factor(static_cast<int>(chosen.cols()));
    factor.add(chosen);
    result.triangles.push_back(factor.triangle());
  }
  return result;
}

}  // namespace artcal
