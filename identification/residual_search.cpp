#include "identification/residual_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/QR>

#include "core/statistics.h"
#include "identification/effect_projection.h"

namespace artcal {
namespace {

constexpr int most_findings = 8;
constexpr double least_noise = 1e-6;  // mm; below, what is left is rounding

/// One family's share of the residuals.
struct Share {
  ModelTest test;
  double evidence = 0.0;  ///< n·log(RSS/RSS′) less log n a column (Schwarz 1978): the strongest wins
};

std::optional<Share> share_of(const EffectFamily& family, const Eigen::MatrixXd& columns,
                              const Eigen::VectorXd& residuals, double degrees_of_freedom) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr = [&] {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> made(columns.middleCols(family.first, family.columns));
    made.setThreshold(least_seen);
    return made;
  }();
  const auto rank = static_cast<int>(qr.rank());
  const double left = degrees_of_freedom - rank;
  if (rank == 0 || columns.middleCols(family.first, family.columns).norm() < least_seen || left < 10.0) {
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
  qr.setThreshold(least_seen);
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
  const double readings = searched.readings();
  double squares = 0.0;
  for (const auto& reading : searched.tips.middleRows(3 * family.first, 3 * family.columns).colwise()) {
    squares += (reading.reshaped(3, family.columns) * coefficients).squaredNorm();
  }
  finding.rms_at_tip = std::sqrt(squares / readings);
  if (family.effect == Effect::Gravity) {
    const auto turnings = searched.turnings.middleRows(family.first, family.columns);
    finding.amplitude = (turnings.transpose() * coefficients).norm() / std::sqrt(readings);
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
  qr.setThreshold(least_seen);
  const Eigen::Index rank = qr.rank();
  columns.applyOnTheLeft(qr.householderQ().transpose());
  residuals.applyOnTheLeft(qr.householderQ().transpose());
  columns = columns.bottomRows(columns.rows() - rank).eval();
  residuals = residuals.tail(residuals.size() - rank).eval();
  columns.middleCols(family.first, family.columns).setZero();
  for (auto column : columns.colwise()) {
    if (column.norm() < least_seen) {
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
  const Searched searched = project_out_the_fit(system, fit, effects);
  Eigen::MatrixXd columns = searched.columns;
  Eigen::VectorXd residuals = searched.residuals;
  double degrees_of_freedom = searched.degrees_of_freedom;
  study.readings = searched.readings();
  while (study.findings.size() < most_findings) {
    std::vector<ModelTest> tests;
    std::vector<std::pair<const EffectFamily*, Share>> shares;
    for (const EffectFamily& candidate : effects.families()) {
      if (const auto share = share_of(candidate, columns, residuals, degrees_of_freedom)) {
        tests.push_back(share->test);
        shares.emplace_back(&candidate, *share);
      }
    }
    const double limit = study.false_alarms / static_cast<double>(std::max<std::size_t>(1, tests.size()));
    std::optional<Share> best;
    const EffectFamily* family = nullptr;
    for (const auto& [candidate, share] : shares) {
      if (share.test.p < limit && (!best || share.evidence > best->evidence)) {
        best = share;
        family = candidate;
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
