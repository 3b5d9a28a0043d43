#include "identification/evaluation/effect_projection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "core/overloaded.h"
#include "identification/least_squares/linearisation.h"
#include "identification/least_squares/rows.h"
#include "identification/least_squares/triangular_factor.h"
#include "identification/monte_carlo/arrow_factor.h"

namespace artcal {
namespace {

constexpr int min_of_feature = 10;
// Weight of an unknown's own row beside its largest column: nothing beside a reading, but a place that its readings do
// not determine keeps its value instead of being free.
constexpr double faint = 1e-7;

/// The rows of a block as they are, not folded.
struct RowsOfBlock {
  Block block;
  BlockColumns columns;
  RowMatrix rows;
  Eigen::Index first = 0;  // among all rows
};

/// Collects the rows of a fit block by block and takes out of them what the fit explains.
class Projection {
 public:
  Projection(const System& system, const ArmFit& fit, const EffectColumns& effects)
      : system_(system),
        fit_(fit),
        effects_(effects),
        kinematics_by_probe_(forward_kinematics_of(system, fit.arm)),
        every_(1 + system.constraints->reading_residual_count() / 3 / max_searched_readings) {
    Eigen::Index readings = 0;
    for (const FeatureConstraint& feature : system.constraints->features) {
      readings += looked_at(feature);
    }
    searched_.rotations.resize(effects.size(), readings);
    searched_.tips.resize(3 * effects.size(), readings);
  }

  Searched search() && {
    Linearisation linearisation;
    linearisation.layout = layout_of(*system_.constraints, system_.arm_size());
    std::vector<RowsOfBlock> blocks;
    for (const Block& block : blocks_of(*system_.constraints)) {
      const BlockColumns columns(block, system_, effects_.size());
      blocks.push_back({block, columns, rows_of(block, columns), rows_});
      rows_ += blocks.back().rows.rows();
      linearisation.blocks.push_back({block.group, block.unknowns, block.parameters, determined(blocks.back())});
    }
    const auto factor = ArrowFactor::of(linearisation);
    if (!factor) {
      return {};
    }
    project(*factor, linearisation.layout, blocks);
    searched_.degrees_of_freedom = static_cast<double>(rows_ - linearisation.layout.size);
    return std::move(searched_);
  }

 private:
  RowMatrix rows_of(const Block& block, const BlockColumns& columns) {
    const Constraints& constraints = *system_.constraints;
    const BlockPoint point = point_of(block, fit_.unknowns);
    Eigen::Index most = static_cast<Eigen::Index>(block.distances.size()) + block.parameters.size;
    for (const int f : block.features) {
      most += looked_at(constraints.features[f]) * constraints.features[f].dimension();
    }
    RowMatrix rows = RowMatrix::Zero(most, columns.all());
    Eigen::Index count = 0;
    const auto add_readings = [&](const FeatureReadings& readings) {
      const auto& [f, feature, residual] = readings;
      const int dimension = feature.dimension();
      const int step = stride(feature);
      for (int k = 0; k < feature.size(); k += step) {
        if (step > 1 || k == 0) {
          weighted_rows(system_, feature, fit_.counted.features[f], kinematics_by_probe_, residual, k,
                        step > 1 ? 1 : feature.size(), columns.out(rows.row(count).data()));
        }
        rows.block(count, columns.fitted(), dimension, columns.beside) = slopes_of(f, k, residual);
        add_observation(count, dimension, units_++);
        count += dimension;
      }
    };
    const auto add_distance = [&](const BindingDistance& distance) {
      auto row = rows.row(count);
      row[columns.residual()] = weighted_distance(distance.distance, constraints,
                                                  fit_.counted.distances[distance.index], point.values, row.data());
      add_observation(count++, 1, unit_of(distance.distance));
    };
    const auto add_certificate = [&](const CertifiedParameter& certified) {
      if (const double weight = fit_.counted.shared[certified.index]; weight > 0.0) {
        rows(count, columns.unknowns + certified.column) = weight;
        rows(count, columns.residual()) = weighted_shared(certified.parameter, weight, point.shared[certified.index]);
        add_observation(count++, 1, units_++);
      }
    };
    for_each_observation(constraints, block, point, Overloaded{add_readings, add_distance, add_certificate});
    return rows.topRows(count);
  }

  void add_observation(Eigen::Index row_of_block, int dimension, int unit) {
    searched_.observations.push_back({rows_ + row_of_block, Eigen::MatrixXd::Zero(dimension, dimension), unit});
  }

  // The error of a certified distance is the same in all placements.
  int unit_of(const DistanceConstraint& distance) {
    const auto& features = system_.constraints->features;
    const FeatureConstraint& first = features[distance.first];
    const auto [entry, is_new] =
        unit_of_distance_.try_emplace({first.artefact, first.feature, features[distance.second].feature}, units_);
    units_ += is_new ? 1 : 0;
    return entry->second;
  }

  // Of the fitted columns only: the effects are many, and the factor of the fit does not look at them.
  [[nodiscard]] static Eigen::MatrixXd determined(const RowsOfBlock& of_block) {
    const BlockColumns& columns = of_block.columns;
    const Eigen::Index fitted = columns.fitted();
    RowMatrix own = RowMatrix::Zero(columns.nuisance(), fitted);
    for (int i = 0; i < columns.nuisance(); ++i) {
      own(i, i) = faint * std::max(1.0, of_block.rows.col(i).norm());
    }
    const Eigen::Index count = of_block.rows.rows();
    if (count + own.rows() <= columns.all()) {
      Eigen::MatrixXd kept(count + own.rows(), fitted);
      kept << of_block.rows.leftCols(fitted), own;
      return kept;
    }
    TriangularFactor factor(columns.fitted());
    factor.add(of_block.rows.leftCols(fitted));
    factor.add(own);
    // As many rows as with the effects' columns, in which those of the effects are zero here.
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(columns.all(), fitted);
    rows.topRows(fitted) = factor.triangle();
    return rows;
  }

  [[nodiscard]] int stride(const FeatureConstraint& feature) const {
    return std::clamp(feature.size() / min_of_feature, 1, every_);
  }
  [[nodiscard]] Eigen::Index looked_at(const FeatureConstraint& feature) const {
    return (feature.size() + stride(feature) - 1) / stride(feature);
  }

  // What a unit of each effect does to a reading's weighted residual.
  Eigen::MatrixXd slopes_of(int f, int k, const FeatureResidual& residual) {
    const FeatureConstraint& feature = system_.constraints->features[f];
    const FeatureWeights& weights = fit_.counted.features[f];
    const int reading = feature.readings[k];
    const int dimension = feature.dimension();
    const ForwardKinematics& kinematics = kinematics_by_probe_[system_.probes[reading]];
    Eigen::Map<Eigen::Matrix3Xd> tips(searched_.tips.col(looked_at_).data(), 3, effects_.size());
    const Eigen::Vector3d tip = effects_.at(reading, kinematics, tips, searched_.rotations.col(looked_at_));
    ++looked_at_;
    const Residual at = residual.at(k, tip, kinematics.tip_radius(), true);
    const Eigen::Matrix3d whitening =
        weights.matrix.empty() ? Eigen::Matrix3d(weights.scalar[k] * Eigen::Matrix3d::Identity()) : weights.matrix[k];
    const Eigen::Matrix3d to_rows = whitening * at.by_tip;
    return to_rows.topRows(dimension).lazyProduct(tips);
  }

  // With Y = R⁻ᵀAᵀ of the fitted columns A the hat matrix is YᵀY; twice, because once leaves rounding errors of the
  // size of the condition number.
  void project(const ArrowFactor& factor, const StateLayout& layout, const std::vector<RowsOfBlock>& blocks) {
    const int z = effects_.size();
    Eigen::MatrixXd all(rows_, z + 1);
    std::vector<Eigen::MatrixXd> halves;
    std::vector<std::vector<Eigen::Index>> positions;
    for (const RowsOfBlock& each : blocks) {
      all.middleRows(each.first, each.rows.rows()) = each.rows.rightCols(z + 1);
      halves.push_back(factor.half_solved(each.block, each.rows.leftCols(each.columns.fitted())));
      positions.push_back(positions_of(factor, layout, each.block));
    }
    const Eigen::VectorXd before = all.leftCols(z).colwise().norm().transpose();
    for (int pass = 0; pass < 2; ++pass) {
      Eigen::MatrixXd explained = Eigen::MatrixXd::Zero(layout.size, z + 1);
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        const Eigen::MatrixXd part = halves[b] * all.middleRows(blocks[b].first, blocks[b].rows.rows());
        for (Eigen::Index i = 0; i < part.rows(); ++i) {
          explained.row(positions[b][static_cast<std::size_t>(i)]) += part.row(i);
        }
      }
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        all.middleRows(blocks[b].first, blocks[b].rows.rows()) -=
            halves[b].transpose() * explained(positions[b], Eigen::all);
      }
    }
    std::size_t observation = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const Eigen::Index end = blocks[b].first + blocks[b].rows.rows();
      for (; observation < searched_.observations.size() && searched_.observations[observation].first < end;
           ++observation) {
        ObservationRows& rows = searched_.observations[observation];
        const auto own = halves[b].middleCols(rows.first - blocks[b].first, rows.hat.rows());
        rows.hat = own.transpose() * own;
      }
    }
    finish(all, before);
  }

  // Where the rows of half_solved() stand among all unknowns.
  static std::vector<Eigen::Index> positions_of(const ArrowFactor& factor, const StateLayout& layout,
                                                const Block& block) {
    std::vector<Eigen::Index> positions;
    for (const int index : factor.reached_by(block)) {
      const auto& columns = factor.eliminated()[static_cast<std::size_t>(index)].columns;
      positions.insert(positions.end(), columns.begin(), columns.end());
    }
    for (Eigen::Index i = layout.arm; i < layout.size; ++i) {
      positions.push_back(i);
    }
    return positions;
  }

  void finish(const Eigen::MatrixXd& left, const Eigen::VectorXd& before) {
    const int z = effects_.size();
    searched_.columns = left.leftCols(z);
    searched_.lengths = searched_.columns.colwise().norm().transpose();
    for (int i = 0; i < z; ++i) {
      const bool is_seen = searched_.lengths[i] > least_seen * before[i] && searched_.lengths[i] > 0.0;
      searched_.columns.col(i) *= is_seen ? 1.0 / searched_.lengths[i] : 0.0;
    }
    searched_.residuals = left.col(z);
  }

  const System& system_;
  const ArmFit& fit_;
  const EffectColumns& effects_;
  std::vector<ForwardKinematics> kinematics_by_probe_;
  int every_;
  Eigen::Index looked_at_ = 0;
  Eigen::Index rows_ = 0;
  int units_ = 0;
  std::map<std::tuple<int, int, int>, int> unit_of_distance_;
  Searched searched_;
};

}  // namespace

Searched project_out_the_fit(const System& system, const ArmFit& fit, const EffectColumns& effects) {
  return Projection(system, fit, effects).search();
}

}  // namespace artcal
