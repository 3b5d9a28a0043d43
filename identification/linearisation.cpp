#include "identification/linearisation.h"

#include <algorithm>
#include <cmath>

#include "identification/rows.h"
#include "identification/triangular_factor.h"

namespace artcal {
namespace {

constexpr int readings_at_once = 32;

/// Buffers that every run of readings uses again.
struct Scratch {
  std::vector<double> residuals, by_arm, by_group;
  RowMatrix rows;
};

// Applies a loss to a run's residuals (and rows): returns Σρ − Σρ'·s, the part of the cost that the rows
// no longer carry.
double reweight(Loss loss, int dimension, Eigen::Ref<Eigen::VectorXd> residuals, RowMatrix* rows) {
  double beyond = 0.0;
  for (Eigen::Index first = 0; first < residuals.size(); first += dimension) {
    auto r = residuals.segment(first, dimension);
    const double s = r.squaredNorm() / dimension;
    const LossValue rho = loss_at(loss, s);
    beyond += dimension * (rho.value - s * rho.slope);
    const double factor = std::sqrt(rho.slope);
    r *= factor;
    if (rows != nullptr) {
      rows->middleRows(first, dimension) *= factor;
    }
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
  return blocks;
}

Eigen::MatrixXd block_triangle(const System& system, const Weights& weights, Loss loss, const Block& block,
                               const std::vector<Sweep>& sweeps, const Eigen::Matrix3d& reference,
                               const double* values) {
  const int arm_size = system.arm_size();
  const int columns = block.unknowns + arm_size + 1;
  TriangularFactor factor(columns);
  Scratch scratch;
  double beyond = 0.0;
  for (const int f : block.features) {
    const FeatureConstraint& feature = system.constraints->features[f];
    for (int first = 0; first < feature.size(); first += readings_at_once) {
      const int count = std::min(readings_at_once, feature.size() - first);
      const int rows = count * feature.dimension();
      scratch.residuals.resize(static_cast<std::size_t>(rows));
      scratch.by_arm.resize(static_cast<std::size_t>(rows * arm_size));
      scratch.by_group.resize(static_cast<std::size_t>(rows * block.unknowns));
      weighted_rows(
          system, feature, weights.features[f], sweeps, reference, values, first, count,
          {scratch.residuals.data(), scratch.by_arm.data(), block.unknowns > 0 ? scratch.by_group.data() : nullptr});
      scratch.rows.resize(rows, columns);
      scratch.rows.leftCols(block.unknowns) = Eigen::Map<RowMatrix>(scratch.by_group.data(), rows, block.unknowns);
      scratch.rows.middleCols(block.unknowns, arm_size) = Eigen::Map<RowMatrix>(scratch.by_arm.data(), rows, arm_size);
      Eigen::Map<Eigen::VectorXd> residuals(scratch.residuals.data(), rows);
      if (loss != Loss::None) {
        beyond += reweight(loss, feature.dimension(), residuals, &scratch.rows);
      }
      scratch.rows.rightCols<1>() = residuals;
      factor.add(scratch.rows.data(), rows);
    }
  }
  for (const int d : block.distances) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(columns);
    row[columns - 1] = weighted_distance(system.constraints->distances[d], *system.constraints, weights.distances[d],
                                         values, row.data());
    factor.add(row.data(), 1);
  }
  Eigen::MatrixXd triangle = factor.triangle();
  double& rest = triangle(columns - 1, columns - 1);
  rest = std::sqrt(rest * rest + beyond);
  return triangle;
}

double block_cost(const System& system, const Weights& weights, Loss loss, const Block& block,
                  const std::vector<Sweep>& sweeps, const Eigen::Matrix3d& reference, const double* values) {
  std::vector<double> residuals;
  double sum = 0.0;
  for (const int f : block.features) {
    const FeatureConstraint& feature = system.constraints->features[f];
    residuals.resize(static_cast<std::size_t>(feature.size() * feature.dimension()));
    weighted_rows(system, feature, weights.features[f], sweeps, reference, values, 0, feature.size(),
                  {residuals.data(), nullptr, nullptr});
    Eigen::Map<Eigen::VectorXd> all(residuals.data(), static_cast<Eigen::Index>(residuals.size()));
    if (loss != Loss::None) {
      sum += reweight(loss, feature.dimension(), all, nullptr);
    }
    sum += all.squaredNorm();
  }
  for (const int d : block.distances) {
    const double residual =
        weighted_distance(system.constraints->distances[d], *system.constraints, weights.distances[d], values, nullptr);
    sum += residual * residual;
  }
  return sum;
}

Linearisation linearise(const System& system, const Weights& weights, Loss loss, const Arm& arm,
                        const Unknowns& unknowns) {
  const auto sweeps = sweeps_of(system, arm);
  const auto blocks = blocks_of(*system.constraints);
  Linearisation result;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const GroupState none;
    const GroupState& group = b == 0 ? none : unknowns[b - 1];
    result.triangles.push_back(
        block_triangle(system, weights, loss, blocks[b], sweeps, group.reference, group.values.data()));
  }
  return result;
}

Eigen::MatrixXd arm_triangle(const Linearisation& linearisation, int arm_size) {
  TriangularFactor factor(arm_size);
  for (const Eigen::MatrixXd& triangle : linearisation.triangles) {
    const auto unknowns = static_cast<int>(triangle.cols()) - 1 - arm_size;
    factor.add(eliminate_leading(triangle.topLeftCorner(unknowns + arm_size, unknowns + arm_size), unknowns));
  }
  return factor.triangle();
}

Linearisation with_parameters(const Linearisation& linearisation, int arm_size, const std::vector<int>& kept) {
  Linearisation result;
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
