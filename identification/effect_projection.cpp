#include "identification/effect_projection.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/QR>

#include "identification/linearisation.h"
#include "identification/rows.h"

namespace artcal {
namespace {

/// Rows of weighted residuals: their derivatives by a block's own unknowns and by what all blocks have in common, the
/// columns of the effects, and the residuals themselves.
struct Columns {
  int own, common, effects;

  [[nodiscard]] int effects_at() const { return own + common; }
  [[nodiscard]] int residual_at() const { return effects_at() + effects; }
  [[nodiscard]] int all() const { return residual_at() + 1; }
};

// Takes out of the other columns all that the leading ones can explain.
Eigen::MatrixXd without_leading(const Eigen::Ref<const Eigen::MatrixXd>& rows, int leading) {
  Eigen::MatrixXd rest = rows.rightCols(rows.cols() - leading);
  if (leading > 0 && rows.rows() > 0) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rows.leftCols(leading));
    qr.setThreshold(1e-12);
    const Eigen::MatrixXd explained = qr.householderQ() * Eigen::MatrixXd::Identity(rows.rows(), qr.rank());
    rest.noalias() -= explained * (explained.transpose() * rest).eval();
  }
  return rest;
}

// As many rows as columns say the same as many of them.
Eigen::MatrixXd as_few_rows(Eigen::MatrixXd rows) {
  if (rows.rows() <= 4 * rows.cols()) {
    return rows;
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(std::move(rows));
  return qr.matrixQR().topRows(qr.cols()).triangularView<Eigen::Upper>();
}

/// Collects the rows of a fit block by block and takes out of them what the fit explains.
class Projection {
 public:
  Projection(const System& system, const ArmFit& fit, const EffectColumns& effects)
      : system_(system),
        fit_(fit),
        effects_(effects),
        sweeps_(sweeps_of(system, fit.arm)),
        every_(1 + system.constraints->reading_residual_count() / 3 / most_searched_readings),
        squares_(Eigen::VectorXd::Zero(effects.size())) {
    Eigen::Index readings = 0;
    for (const FeatureConstraint& feature : system.constraints->features) {
      readings += looked_at(feature);
    }
    searched_.turnings.resize(effects.size(), readings);
    searched_.tips.resize(3 * effects.size(), readings);
  }

  Searched search() && {
    const int common = system_.shared_size() + system_.arm_size();
    std::vector<Eigen::MatrixXd> parts;
    Eigen::Index rows = 0;
    int unknowns = common;
    const auto blocks = blocks_of(*system_.constraints);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      unknowns += blocks[b].unknowns;
      parts.push_back(
          without_leading(rows_of(blocks[b], b == 0 ? none_ : fit_.unknowns.groups[b - 1]), blocks[b].unknowns));
      rows += parts.back().rows();
    }
    Eigen::MatrixXd all(rows, common + effects_.size() + 1);
    rows = 0;
    for (const Eigen::MatrixXd& part : parts) {
      all.middleRows(rows, part.rows()) = part;
      rows += part.rows();
    }
    finish(as_few_rows(without_leading(all, common)));
    searched_.degrees_of_freedom = counted_rows_ - unknowns;
    return std::move(searched_);
  }

 private:
  RowMatrix rows_of(const Block& block, const GroupState& group) {
    const Constraints& constraints = *system_.constraints;
    const int shared = system_.shared_size();
    const Columns columns{block.unknowns, shared + system_.arm_size(), effects_.size()};
    RowMatrix rows = RowMatrix::Zero(row_count(block), columns.all());
    Eigen::Index next = 0;
    for (const int f : block.features) {
      const FeatureConstraint& feature = constraints.features[f];
      const FeatureResidual residual(feature, group.reference, group.values.data(), fit_.unknowns.shared.data());
      for (int k = 0; k < feature.size(); k += every_) {
        double* row = rows.row(next).data();
        weighted_rows(system_, feature, fit_.counted.features[f], sweeps_, residual, k, 1,
                      {columns.all(), row + columns.residual_at(), row + block.unknowns + shared,
                       block.unknowns > 0 ? row : nullptr, shared > 0 ? row + block.unknowns : nullptr});
        rows.block(next, columns.effects_at(), feature.dimension(), columns.effects) = slopes_of(f, k, residual);
        next += feature.dimension();
      }
    }
    for (const int d : block.distances) {
      rows(next, columns.residual_at()) = weighted_distance(
          constraints.distances[d], constraints, fit_.counted.distances[d], group.values.data(), rows.row(next).data());
      ++next;
    }
    for (int s = 0; block.has_shared && s < shared; ++s) {
      const double weight = fit_.counted.shared[s];
      if (weight > 0.0) {
        rows(next, block.unknowns + s) = weight;
        rows(next, columns.residual_at()) = weighted_shared(constraints.shared[s], weight, fit_.unknowns.shared[s]);
        ++next;
      }
    }
    counted_rows_ += static_cast<int>(next);
    return rows.topRows(next);
  }

  [[nodiscard]] Eigen::Index looked_at(const FeatureConstraint& feature) const {
    return (feature.size() + every_ - 1) / every_;
  }

  [[nodiscard]] Eigen::Index row_count(const Block& block) const {
    Eigen::Index count =
        static_cast<Eigen::Index>(block.distances.size()) + (block.has_shared ? system_.shared_size() : 0);
    for (const int f : block.features) {
      const FeatureConstraint& feature = system_.constraints->features[f];
      count += feature.dimension() * looked_at(feature);
    }
    return count;
  }

  // What a unit of each effect does to a reading's weighted residual.
  Eigen::MatrixXd slopes_of(int f, int k, const FeatureResidual& residual) {
    const FeatureConstraint& feature = system_.constraints->features[f];
    const FeatureWeights& weights = fit_.counted.features[f];
    const int reading = feature.readings[k];
    const int dimension = feature.dimension();
    const Sweep& sweep = sweeps_[system_.probes[reading]];
    Eigen::Map<Eigen::Matrix3Xd> tips(searched_.tips.col(looked_at_).data(), 3, effects_.size());
    effects_.at(reading, sweep, tips, searched_.turnings.col(looked_at_));
    ++looked_at_;
    const Residual at = residual.at(k, sweep.tip_in_base(system_.sines_of(reading)), sweep.tip_radius(), true);
    const Eigen::Matrix3d whitening =
        weights.matrix.empty() ? Eigen::Matrix3d(weights.scalar[k] * Eigen::Matrix3d::Identity()) : weights.matrix[k];
    const Eigen::Matrix3d to_rows = whitening * at.by_tip;
    Eigen::MatrixXd slopes = to_rows.topRows(dimension).lazyProduct(tips);
    squares_ += slopes.colwise().squaredNorm().transpose();
    return slopes;
  }

  void finish(const Eigen::MatrixXd& left) {
    const int z = effects_.size();
    searched_.columns = left.leftCols(z);
    searched_.lengths = searched_.columns.colwise().norm().transpose();
    for (int i = 0; i < z; ++i) {
      const bool is_seen = searched_.lengths[i] > least_seen * std::sqrt(squares_[i]) && searched_.lengths[i] > 0.0;
      searched_.columns.col(i) *= is_seen ? 1.0 / searched_.lengths[i] : 0.0;
    }
    searched_.residuals = left.col(z);
  }

  const System& system_;
  const ArmFit& fit_;
  const EffectColumns& effects_;
  const GroupState none_;
  std::vector<Sweep> sweeps_;
  int every_;
  Eigen::VectorXd squares_;  // of each effect's column before anything was taken out
  Eigen::Index looked_at_ = 0;
  int counted_rows_ = 0;
  Searched searched_;
};

}  // namespace

Searched project_out_the_fit(const System& system, const ArmFit& fit, const EffectColumns& effects) {
  return Projection(system, fit, effects).search();
}

}  // namespace artcal
