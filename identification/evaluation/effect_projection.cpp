#include "identification/evaluation/effect_projection.h"

#include <cmath>
#include <utility>
#include <vector>

#include "identification/least_squares/elimination.h"
#include "identification/least_squares/linearisation.h"
#include "identification/least_squares/row_stack.h"
#include "identification/least_squares/rows.h"

namespace artcal {
namespace {

/// Columns of a block's weighted rows: its nuisance unknowns, the arm's parameters, the effects, the residuals.
struct Columns {
  int nuisance, arm, effects;

  [[nodiscard]] int effects_at() const { return nuisance + arm; }
  [[nodiscard]] int residual_at() const { return effects_at() + effects; }
  [[nodiscard]] int all() const { return residual_at() + 1; }
};

/// Collects the rows of a fit block by block and takes out of them what the fit explains.
class Projection {
 public:
  Projection(const System& system, const ArmFit& fit, const EffectColumns& effects)
      : system_(system),
        fit_(fit),
        effects_(effects),
        kinematics_by_probe_(forward_kinematics_of(system, fit.arm)),
        every_(1 + system.constraints->reading_residual_count() / 3 / max_searched_readings),
        squares_(Eigen::VectorXd::Zero(effects.size())) {
    Eigen::Index readings = 0;
    for (const FeatureConstraint& feature : system.constraints->features) {
      readings += looked_at(feature);
    }
    searched_.rotations.resize(effects.size(), readings);
    searched_.tips.resize(3 * effects.size(), readings);
  }

  Searched search() && {
    Linearisation with_effects;
    with_effects.layout = layout_of(*system_.constraints, system_.arm_size());
    for (const Block& block : blocks_of(*system_.constraints)) {
      with_effects.blocks.push_back({block.group, block.unknowns, block.parameters,
                                     rows_of(block, block.group < 0 ? none_ : fit_.unknowns.groups[block.group])});
    }
    const Eigen::MatrixXd triangle = eliminate_nuisance(with_effects, system_.arm_size() + effects_.size() + 1);
    finish(eliminate_leading(triangle, system_.arm_size()));
    searched_.degrees_of_freedom = counted_rows_ - static_cast<double>(with_effects.layout.size);
    return std::move(searched_);
  }

 private:
  Eigen::MatrixXd rows_of(const Block& block, const GroupState& group) {
    const Constraints& constraints = *system_.constraints;
    const Columns columns{block.nuisance(), system_.arm_size(), effects_.size()};
    RowStack stack(columns.all());
    RowMatrix rows(3, columns.all());
    for (const int f : block.features) {
      const FeatureConstraint& feature = constraints.features[f];
      const FeatureResidual residual(feature, group.reference, group.values.data(), fit_.unknowns.shared.data());
      for (int k = 0; k < feature.size(); k += every_) {
        rows.setZero();
        double* row = rows.data();
        weighted_rows(
            system_, feature, fit_.counted.features[f], kinematics_by_probe_, residual, k, 1,
            {columns.all(), row + columns.residual_at(), row + columns.nuisance, block.unknowns > 0 ? row : nullptr,
             block.parameters.size > 0 ? row + block.unknowns : nullptr, block.parameters.first});
        const int dimension = feature.dimension();
        rows.block(0, columns.effects_at(), dimension, columns.effects) = slopes_of(f, k, residual);
        stack.add(rows.topRows(dimension));
        counted_rows_ += dimension;
      }
    }
    Eigen::RowVectorXd row(columns.all());
    for (const int d : block.distances) {
      row.setZero();
      row[columns.residual_at()] = weighted_distance(constraints.distances[d], constraints, fit_.counted.distances[d],
                                                     group.values.data(), row.data());
      stack.add(row);
      ++counted_rows_;
    }
    for (int i = 0; block.has_certificate && i < block.parameters.size; ++i) {
      const int s = block.parameters.first + i;
      const double weight = fit_.counted.shared[s];
      if (weight > 0.0) {
        row.setZero();
        row[block.unknowns + i] = weight;
        row[columns.residual_at()] = weighted_shared(constraints.shared[s], weight, fit_.unknowns.shared[s]);
        stack.add(row);
        ++counted_rows_;
      }
    }
    return stack.rows();
  }

  [[nodiscard]] Eigen::Index looked_at(const FeatureConstraint& feature) const {
    return (feature.size() + every_ - 1) / every_;
  }

  // What a unit of each effect does to a reading's weighted residual.
  Eigen::MatrixXd slopes_of(int f, int k, const FeatureResidual& residual) {
    const FeatureConstraint& feature = system_.constraints->features[f];
    const FeatureWeights& weights = fit_.counted.features[f];
    const int reading = feature.readings[k];
    const int dimension = feature.dimension();
    const ForwardKinematics& kinematics = kinematics_by_probe_[system_.probes[reading]];
    Eigen::Map<Eigen::Matrix3Xd> tips(searched_.tips.col(looked_at_).data(), 3, effects_.size());
    effects_.at(reading, kinematics, tips, searched_.rotations.col(looked_at_));
    ++looked_at_;
    const Residual at =
        residual.at(k, kinematics.tip_in_base(system_.sines_of(reading)), kinematics.tip_radius(), true);
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
  std::vector<ForwardKinematics> kinematics_by_probe_;
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
