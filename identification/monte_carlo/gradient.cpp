#include "identification/monte_carlo/gradient.h"

#include <algorithm>

#include "core/overloaded.h"

namespace artcal {
namespace {

constexpr int readings_in_step = 32;

// Each reading's residuals by the slope of the loss.
void reweight(Loss loss, int dimension, const FeatureWeights& weights, int reading,
              Eigen::Ref<Eigen::VectorXd> residuals) {
  for (Eigen::Index first = 0; first < residuals.size(); first += dimension, ++reading) {
    auto own = residuals.segment(first, dimension);
    own *= loss_of(loss, own.squaredNorm(), expected_square(weights, reading, dimension)).slope;
  }
}

}  // namespace

GradientScratch gradient_scratch(const System& system) {
  GradientScratch scratch{blocks_of(*system.constraints), {}, Eigen::VectorXd(3 * readings_in_step)};
  int columns = 0;
  for (const Block& block : scratch.blocks) {
    columns = std::max(columns, BlockColumns(block, system).all());
  }
  scratch.rows.resize(3 * readings_in_step, columns);
  return scratch;
}

Eigen::VectorXd gradient(const System& system, const Weights& weights, Loss loss, const StateLayout& layout,
                         const Unknowns& unknowns, const Eigen::VectorXd& numbers, GradientScratch& scratch) {
  const Constraints& constraints = *system.constraints;
  const auto kinematics_by_probe = forward_kinematics_of(system, system.arm_at(numbers.data() + layout.arm));
  const double* shared = numbers.data() + layout.common;
  const GroupReference none;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(layout.size);
  auto by_arm = sum.tail(system.arm_size());
  Eigen::VectorXd row;
  for (const Block& block : scratch.blocks) {
    const Eigen::Index at = block.group < 0 ? 0 : layout.groups[block.group];
    const BlockPoint point{block.group < 0 ? none : unknowns.groups[block.group].reference, numbers.data() + at,
                           shared};
    auto by_group = sum.segment(at, block.unknowns);
    auto by_parameters = sum.segment(layout.common + block.parameters.first, block.parameters.size);
    const BlockColumns columns(block, system);
    Eigen::Map<RowMatrix> rows(scratch.rows.data(), 3 * readings_in_step, columns.all());
    const auto add_readings = [&](const FeatureReadings& readings) {
      const auto& [f, feature, residual] = readings;
      rows.leftCols(columns.nuisance()).setZero();  // each feature fills its own columns only
      for (int first = 0; first < feature.size(); first += readings_in_step) {
        const int count = std::min(readings_in_step, feature.size() - first);
        const Eigen::Index used = count * feature.dimension();
        weighted_rows(system, feature, weights.features[f], kinematics_by_probe, residual, first, count,
                      columns.out(rows.data()));
        auto r = scratch.residuals.head(used);
        r = rows.col(columns.residual()).head(used);
        if (loss != Loss::None) {
          reweight(loss, feature.dimension(), weights.features[f], first, r);
        }
        by_group.noalias() += rows.topLeftCorner(used, block.unknowns).transpose() * r;
        by_parameters.noalias() += rows.block(0, block.unknowns, used, block.parameters.size).transpose() * r;
        by_arm.noalias() += rows.block(0, columns.nuisance(), used, system.arm_size()).transpose() * r;
      }
    };
    const auto add_distance = [&](const BindingDistance& distance) {
      row.resize(block.unknowns);
      const double r = weighted_distance(distance.distance, constraints, weights.distances[distance.index],
                                         point.values, row.data());
      const double slope = loss_reaches_distances(loss, weights)
                               ? loss_of(loss, r * r, weights.distance_variance[distance.index]).slope
                               : 1.0;
      by_group += slope * r * row;
    };
    const auto add_certificate = [&](const CertifiedParameter& certified) {
      const double weight = weights.shared[certified.index];
      const double r = weighted_shared(certified.parameter, weight, shared[certified.index]);
      const double slope = loss_reaches_shared(loss, weights)
                               ? loss_of(loss, r * r, weights.shared_variance[certified.index]).slope
                               : 1.0;
      by_parameters[certified.column] += slope * weight * r;
    };
    for_each_observation(constraints, block, point, Overloaded{add_readings, add_distance, add_certificate});
  }
  return sum;
}

Eigen::VectorXd gradient(const Linearisation& linearisation) {
  const StateLayout& layout = linearisation.layout;
  const Eigen::Index arm_size = layout.size - layout.arm;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(layout.size);
  for (const BlockRows& block : linearisation.blocks) {
    const Eigen::VectorXd all =
        block.rows.leftCols(block.nuisance() + arm_size).transpose() * block.rows.rightCols<1>();
    if (block.group >= 0) {
      sum.segment(layout.groups[block.group], block.unknowns) += all.head(block.unknowns);
    }
    sum.segment(layout.common + block.parameters.first, block.parameters.size) +=
        all.segment(block.unknowns, block.parameters.size);
    sum.tail(arm_size) += all.tail(arm_size);
  }
  return sum;
}

}  // namespace artcal
