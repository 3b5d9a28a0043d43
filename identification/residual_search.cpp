#include "identification/residual_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/QR>

#include "core/statistics.h"
#include "identification/effect_columns.h"
#include "identification/rows.h"
#include "identification/triangular_factor.h"

namespace artcal {
namespace {

constexpr int most_readings = 4000;
constexpr int most_findings = 8;
constexpr double least_noise = 1e-6;  // mm; below, what is left is rounding
constexpr double seen = 1e-6;         // share of a column that the fitted model must leave

/// The residuals and the effects' columns with all that was fitted projected out.
struct Searched {
  Eigen::MatrixXd columns;  ///< each of length one, or zero where nothing of it is left
  Eigen::VectorXd lengths;  ///< that they had
  Eigen::VectorXd residuals;
  double degrees_of_freedom = 0.0;
  int readings = 0;
  Eigen::MatrixXd turnings;        ///< readings × columns: what each does to its joint
  Eigen::MatrixXd tip_covariance;  ///< mean over the readings of the tip's motion: columns × columns, mm²
};

Searched project(const System& system, const ArmFit& fit, const EffectColumns& effects) {
  const Constraints& constraints = *system.constraints;
  const auto sweeps = sweeps_of(system, fit.arm);
  const int every = 1 + constraints.reading_residual_count() / 3 / most_readings;
  const int z = effects.size();
  const int common = system.shared_size() + system.arm_size();
  Searched searched;
  searched.tip_covariance = Eigen::MatrixXd::Zero(z, z);
  Eigen::VectorXd before = Eigen::VectorXd::Zero(z);
  TriangularFactor rest(common + z + 1);
  Eigen::Matrix3Xd tips(3, z);
  Eigen::VectorXd turnings(z);
  std::vector<Eigen::VectorXd> all_turnings;
  int rows_in_all = 0;
  int unknowns = common;
  const auto blocks = blocks_of(constraints);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    const GroupState none;
    const GroupState& group = b == 0 ? none : fit.unknowns.groups[b - 1];
    const int before_arm = block.unknowns + system.shared_size();
    const int columns = block.unknowns + common + z + 1;
    TriangularFactor factor(columns);
    unknowns += block.unknowns;
    for (const int f : block.features) {
      const FeatureConstraint& feature = constraints.features[f];
      const FeatureWeights& weights = fit.weights.features[f];
      const FeatureResidual residual(feature, group.reference, group.values.data(), fit.unknowns.shared.data());
      for (int k = 0; k < feature.size(); k += every) {
        const int reading = feature.readings[k];
        const int dimension = feature.dimension();
        RowMatrix rows = RowMatrix::Zero(dimension, columns);
        weighted_rows(
            system, feature, weights, sweeps, residual, k, 1,
            {columns, rows.data() + columns - 1, rows.data() + before_arm, block.unknowns > 0 ? rows.data() : nullptr,
             system.shared_size() > 0 ? rows.data() + block.unknowns : nullptr});
        const Sweep& sweep = sweeps[system.probes[reading]];
        effects.at(reading, sweep, tips, turnings);
        const Residual at = residual.at(k, sweep.tip_in_base(system.sines_of(reading)), sweep.tip_radius(), true);
        const Eigen::Matrix3d whitening = weights.matrix.empty()
                                              ? Eigen::Matrix3d(weights.scalar[k] * Eigen::Matrix3d::Identity())
                                              : weights.matrix[k];
        const Eigen::MatrixXd slope =
            whitening.topLeftCorner(dimension, dimension) * at.by_tip.topRows(dimension) * tips;
        rows.middleCols(before_arm + system.arm_size(), z) = slope;
        before += slope.colwise().squaredNorm().transpose();
        searched.tip_covariance += tips.transpose() * tips;
        all_turnings.push_back(turnings);
        factor.add(rows.data(), dimension);
        rows_in_all += dimension;
      }
    }
    Eigen::RowVectorXd row(columns);
    for (const int d : block.distances) {
      row.setZero();
      row[columns - 1] = weighted_distance(constraints.distances[d], constraints, fit.weights.distances[d],
                                           group.values.data(), row.data());
      factor.add(row.data(), 1);
      ++rows_in_all;
    }
    for (int s = 0; block.has_shared && s < system.shared_size(); ++s) {
      row.setZero();
      row[block.unknowns + s] = fit.weights.shared[s];
      row[columns - 1] = weighted_shared(constraints.shared[s], fit.weights.shared[s], fit.unknowns.shared[s]);
      factor.add(row.data(), 1);
      rows_in_all += fit.weights.shared[s] > 0.0 ? 1 : 0;
    }
    rest.add(eliminate_leading(factor.triangle(), block.unknowns));
  }
  const Eigen::MatrixXd left = eliminate_leading(rest.triangle(), common);
  searched.columns = left.leftCols(z);
  searched.lengths = searched.columns.colwise().norm().transpose();
  for (int i = 0; i < z; ++i) {
    const bool is_seen = searched.lengths[i] > seen * std::sqrt(before[i]) && searched.lengths[i] > 0.0;
    searched.columns.col(i) *= is_seen ? 1.0 / searched.lengths[i] : 0.0;
  }
  searched.residuals = left.col(z);
  searched.degrees_of_freedom = rows_in_all - unknowns;
  searched.readings = static_cast<int>(all_turnings.size());
  searched.turnings.resize(searched.readings, z);
  for (int i = 0; i < searched.readings; ++i) {
    searched.turnings.row(i) = all_turnings[static_cast<std::size_t>(i)].transpose();
  }
  searched.tip_covariance /= std::max(1, searched.readings);
  return searched;
}

/// One family's share of the residuals.
struct Share {
  ModelTest test;
  double evidence = 0.0;  ///< n·log(RSS/RSS′) less log n a column (Schwarz 1978): the strongest wins
};

std::optional<Share> share_of(const EffectFamily& family, const Eigen::MatrixXd& columns,
                              const Eigen::VectorXd& residuals, double degrees_of_freedom) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr = [&] {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> made(columns.middleCols(family.first, family.columns));
    made.setThreshold(seen);
    return made;
  }();
  const auto rank = static_cast<int>(qr.rank());
  const double left = degrees_of_freedom - rank;
  if (rank == 0 || columns.middleCols(family.first, family.columns).norm() < seen || left < 10.0) {
    return std::nullopt;
  }
  Eigen::VectorXd turned = residuals;
  turned.applyOnTheLeft(qr.householderQ().transpose());
  const double explained = turned.head(rank).squaredNorm();
  const double rest = turned.tail(turned.size() - rank).squaredNorm();
  const double f = explained / rank / (rest / left);
  return Share{{family.effect, family.joint, rank, f, f_probability_above(f, rank, left)},
               degrees_of_freedom * std::log1p(explained / rest) - rank * std::log(degrees_of_freedom)};
}

ModelFinding finding_of(const EffectFamily& family, const Share& share, const Eigen::MatrixXd& columns,
                        const Eigen::VectorXd& residuals, const Searched& searched) {
  const Eigen::MatrixXd own = columns.middleCols(family.first, family.columns);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(own);
  qr.setThreshold(seen);
  const auto lengths = searched.lengths.segment(family.first, family.columns);
  // The residual is model less truth: what is missing has the other sign.
  const Eigen::VectorXd coefficients = -Eigen::VectorXd(qr.solve(residuals)).cwiseQuotient(lengths);
  ModelFinding finding{family.effect, family.joint, share.test.p};
  const double variance = (residuals + own * coefficients.cwiseProduct(lengths)).squaredNorm() /
                          (searched.degrees_of_freedom - family.columns);
  const Eigen::MatrixXd inverse =
      lengths.cwiseInverse().asDiagonal() *
      Eigen::MatrixXd(own.transpose() * own).completeOrthogonalDecomposition().pseudoInverse() *
      lengths.cwiseInverse().asDiagonal();
  const auto turnings = searched.turnings.middleCols(family.first, family.columns);
  finding.rms_at_tip = std::sqrt(coefficients.dot(
      searched.tip_covariance.block(family.first, family.first, family.columns, family.columns) * coefficients));
  if (family.effect == Effect::Gravity) {
    finding.amplitude = (turnings * coefficients).norm() / std::sqrt(static_cast<double>(searched.readings));
  } else if (family.columns == 2) {
    finding.amplitude = coefficients.norm();
    finding.phase = std::atan2(coefficients[1], coefficients[0]);
    const Eigen::Vector2d slope = coefficients.normalized();
    finding.u_amplitude = std::sqrt(variance * slope.dot(inverse * slope));
  } else {
    finding.amplitude = coefficients[0];
    finding.u_amplitude = std::sqrt(variance * inverse(0, 0));
  }
  return finding;
}

// Takes the family out of the residuals and of all columns.
void remove_family(const EffectFamily& family, Eigen::MatrixXd& columns, Eigen::VectorXd& residuals) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns.middleCols(family.first, family.columns));
  qr.setThreshold(seen);
  const Eigen::Index rank = qr.rank();
  columns.applyOnTheLeft(qr.householderQ().transpose());
  residuals.applyOnTheLeft(qr.householderQ().transpose());
  columns = columns.bottomRows(columns.rows() - rank).eval();
  residuals = residuals.tail(residuals.size() - rank).eval();
  columns.middleCols(family.first, family.columns).setZero();
  for (auto column : columns.colwise()) {
    if (column.norm() < seen) {
      column.setZero();
    }
  }
}

}  // namespace

ModelStudy search_residuals(const System& system, const ArmFit& fit, const Recording& recording) {
  ModelStudy study;
  if (fit.noise < least_noise) {
    return study;
  }
  const EffectColumns effects(system, recording);
  const Searched searched = project(system, fit, effects);
  Eigen::MatrixXd columns = searched.columns;
  Eigen::VectorXd residuals = searched.residuals;
  double degrees_of_freedom = searched.degrees_of_freedom;
  study.readings = searched.readings;
  while (study.findings.size() < most_findings) {
    std::optional<Share> best;
    const EffectFamily* family = nullptr;
    std::vector<ModelTest> tests;
    for (const EffectFamily& candidate : effects.families()) {
      const auto share = share_of(candidate, columns, residuals, degrees_of_freedom);
      if (share) {
        tests.push_back(share->test);
      }
    }
    const double limit = study.false_alarms / static_cast<double>(std::max<std::size_t>(1, tests.size()));
    for (const EffectFamily& candidate : effects.families()) {
      const auto share = share_of(candidate, columns, residuals, degrees_of_freedom);
      if (share && share->test.p < limit && (!best || share->evidence > best->evidence)) {
        best = share;
        family = &candidate;
      }
    }
    if (study.findings.empty()) {
      study.tests = tests;
      study.done = !tests.empty();
    }
    if (!best) {
      break;
    }
    study.findings.push_back(finding_of(*family, *best, columns, residuals, searched));
    remove_family(*family, columns, residuals);
    degrees_of_freedom -= best->test.columns;
  }
  return study;
}

}  // namespace artcal
