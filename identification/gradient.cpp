#include "identification/gradient.h"

#include <algorithm>

namespace artcal {
namespace {

constexpr int readings_at_once = 32;

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
  GradientScratch scratch{blocks_of(*system.constraints), {}, Eigen::VectorXd(3 * readings_at_once)};
  int columns = 0;
  for (const Block& block : scratch.blocks) {
    columns = std::max(columns, block.unknowns + system.shared_size() + system.arm_size() + 1);
  }
  scratch.rows.resize(3 * readings_at_once, columns);
  return scratch;
}

Eigen::VectorXd gradient(const System& system, const Weights& weights, Loss loss, const NumberLayout& layout,
                         const Unknowns& unknowns, const Eigen::VectorXd& numbers, GradientScratch& scratch) {
  const Constraints& constraints = *system.constraints;
  const auto sweeps = sweeps_of(system, system.arm_at(numbers.data() + layout.arm));
  const double* shared = numbers.data() + layout.common;
  const GroupReference none;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(layout.size);
  auto by_common = sum.tail(layout.size - layout.common);
  Eigen::VectorXd row;
  for (std::size_t b = 0; b < scratch.blocks.size(); ++b) {
    const Block& block = scratch.blocks[b];
    const Eigen::Index at = b == 0 ? 0 : layout.groups[b - 1];
    const double* values = numbers.data() + at;
    auto by_group = sum.segment(at, block.unknowns);
    const int before_arm = block.unknowns + system.shared_size();
    const int columns = before_arm + system.arm_size() + 1;
    Eigen::Map<RowMatrix> rows(scratch.rows.data(), 3 * readings_at_once, columns);
    for (const int f : block.features) {
      const FeatureConstraint& feature = constraints.features[f];
      const FeatureResidual residual(feature, b == 0 ? none : unknowns.groups[b - 1].reference, values, shared);
      rows.leftCols(before_arm).setZero();  // each feature fills its own columns only
      for (int first = 0; first < feature.size(); first += readings_at_once) {
        const int count = std::min(readings_at_once, feature.size() - first);
        const Eigen::Index used = count * feature.dimension();
        weighted_rows(
            system, feature, weights.features[f], sweeps, residual, first, count,
            {columns, rows.data() + columns - 1, rows.data() + before_arm, block.unknowns > 0 ? rows.data() : nullptr,
             system.shared_size() > 0 ? rows.data() + block.unknowns : nullptr});
        auto r = scratch.residuals.head(used);
        r = rows.col(columns - 1).head(used);
        if (loss != Loss::None) {
          reweight(loss, feature.dimension(), weights.features[f], first, r);
        }
        by_group.noalias() += rows.topLeftCorner(used, block.unknowns).transpose() * r;
        by_common.noalias() += rows.block(0, block.unknowns, used, columns - 1 - block.unknowns).transpose() * r;
      }
    }
    row.resize(block.unknowns);
    for (const int d : block.distances) {
      const double r =
          weighted_distance(constraints.distances[d], constraints, weights.distances[d], values, row.data());
      const double slope =
          loss_reaches_distances(loss, weights) ? loss_of(loss, r * r, weights.distance_variance[d]).slope : 1.0;
      by_group += slope * r * row;
    }
    for (int s = 0; block.has_shared && s < system.shared_size(); ++s) {
      const double r = weighted_shared(constraints.shared[s], weights.shared[s], shared[s]);
      const double slope =
          loss_reaches_shared(loss, weights) ? loss_of(loss, r * r, weights.shared_variance[s]).slope : 1.0;
      by_common[s] += slope * weights.shared[s] * r;
    }
  }
  return sum;
}

Eigen::VectorXd gradient(const Linearisation& linearisation, const NumberLayout& layout) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(layout.size);
  const Eigen::Index common = layout.size - layout.common;
  for (std::size_t b = 0; b < linearisation.triangles.size(); ++b) {
    const Eigen::MatrixXd& triangle = linearisation.triangles[b];
    const Eigen::Index own = triangle.cols() - 1 - common;
    const Eigen::VectorXd all = triangle.leftCols(own + common).transpose() * triangle.rightCols<1>();
    if (own > 0) {
      sum.segment(layout.groups[b - 1], own) += all.head(own);
    }
    sum.tail(common) += all.tail(common);
  }
  return sum;
}

}  // namespace artcal
