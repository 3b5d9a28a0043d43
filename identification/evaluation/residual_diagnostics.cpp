#include "identification/evaluation/residual_diagnostics.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/QR>

#include "acquisition/arm/joint_error_keys.h"
#include "core/statistics.h"
#include "identification/evaluation/effect_projection.h"
#include "identification/evaluation/score_test.h"

namespace artcal {
namespace {

constexpr int max_findings = 8;
constexpr double rounding_noise = 1e-6;  // mm; below, what is left is rounding

// More than a joint that works turns by without its encoder: rad, rms over the readings, their mean taken off.
constexpr double max_rotation = 0.01;

/// One family's share of the residuals.
struct Share {
  ModelTest test;
  std::vector<int> columns;  ///< of its columns, by index into all, those that explain
  double p = 1.0;            ///< of what they explain
  double evidence = 0.0;     ///< n·log(RSS/RSS′) less log n a column (Schwarz 1978): the strongest wins
};

using PivotedQr = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;

PivotedQr factored(const Eigen::MatrixXd& columns) {
  PivotedQr qr(columns.rows(), columns.cols());
  qr.setThreshold(least_seen);
  qr.compute(columns);
  return qr;
}

double explained_by(const PivotedQr& qr, const Eigen::VectorXd& residuals) {
  Eigen::VectorXd rotated = residuals;
  rotated.applyOnTheLeft(qr.householderQ().transpose());
  return rotated.head(qr.rank()).squaredNorm();
}

// All columns of a family, or of Gravity those that are left when no coefficient may be below zero: a joint gives way
// to a weight and never against it. The most negative goes first, until none is.
std::vector<int> physical_columns(const EffectFamily& family, const Eigen::MatrixXd& columns,
                                  const Eigen::VectorXd& residuals) {
  std::vector<int> kept;
  for (int i = family.first; i < family.first + family.columns; ++i) {
    if (columns.col(i).norm() >= least_seen) {
      kept.push_back(i);
    }
  }
  while (family.effect == Effect::Gravity && !kept.empty()) {
    // The residual is model less truth: what is missing has the other sign.
    const Eigen::VectorXd coefficients = -factored(columns(Eigen::all, kept)).solve(residuals);
    Eigen::Index lowest = 0;
    if (coefficients.minCoeff(&lowest) >= 0.0) {
      break;
    }
    kept.erase(kept.begin() + lowest);
  }
  return kept;
}

// An orthonormal basis of these columns.
Eigen::MatrixXd basis_of(const PivotedQr& qr) {
  Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(qr.rows(), qr.rank());
  basis.applyOnTheLeft(qr.householderQ());
  return basis;
}

/// What is left of a fit's rows beside the findings so far.
struct Remainder {
  Searched rows;
  Eigen::VectorXd adjusted;  ///< leverage_adjusted() residuals

  explicit Remainder(Searched searched)
      : rows(std::move(searched)), adjusted(leverage_adjusted(rows.residuals, rows.observations)) {}

  [[nodiscard]] double statistic(const PivotedQr& qr) const {
    return score_statistic(basis_of(qr), rows.residuals, adjusted, rows.observations);
  }
};

std::optional<Share> share_of(const EffectFamily& family, const Remainder& left) {
  const Eigen::MatrixXd own = left.rows.columns.middleCols(family.first, family.columns);
  const PivotedQr qr = factored(own);
  const auto rank = static_cast<int>(qr.rank());
  if (rank == 0 || own.norm() < least_seen || left.rows.degrees_of_freedom - rank < 10.0) {
    return std::nullopt;
  }
  const double statistic = left.statistic(qr);
  Share share{{family.effect, family.joint, rank, statistic, chi_squared_probability_above(statistic, rank)},
              physical_columns(family, left.rows.columns, left.rows.residuals)};
  if (!share.columns.empty()) {
    // Fewer columns explain less: with the degrees of freedom of all of them the test keeps its size.
    const PivotedQr physical = factored(left.rows.columns(Eigen::all, share.columns));
    share.p = chi_squared_probability_above(left.statistic(physical), rank);
    const double whole = left.rows.residuals.squaredNorm();
    const double explained = explained_by(physical, left.rows.residuals);
    const double freedom = left.rows.degrees_of_freedom;
    share.evidence = freedom * std::log1p(explained / (whole - explained)) - rank * std::log(freedom);
  }
  return share;
}

ModelFinding finding_of(const EffectFamily& family, const Share& share, const Searched& searched) {
  const Eigen::MatrixXd& columns = searched.columns;
  const Eigen::VectorXd& residuals = searched.residuals;
  const Eigen::MatrixXd own = columns(Eigen::all, share.columns);
  const Eigen::VectorXd lengths = searched.lengths(share.columns);
  const Eigen::VectorXd solved = -factored(own).solve(residuals).cwiseQuotient(lengths);
  Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(family.columns);
  for (std::size_t i = 0; i < share.columns.size(); ++i) {
    coefficients[share.columns[i] - family.first] = solved[static_cast<Eigen::Index>(i)];
  }
  ModelFinding finding{family.effect, family.joint, share.p};
  const double variance =
      (residuals + own * solved.cwiseProduct(lengths)).squaredNorm() / (searched.degrees_of_freedom - family.columns);
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
  Eigen::VectorXd rotations = searched.rotations.middleRows(family.first, family.columns).transpose() * coefficients;
  if (family.effect == Effect::Gravity) {
    finding.amplitude = rotations.norm() / std::sqrt(readings);
  } else if (family.columns == 2) {
    finding.amplitude = coefficients.norm();
    finding.phase = std::atan2(coefficients[1], coefficients[0]);
    if (share.columns.size() == 2) {
      const Eigen::Vector2d slope = coefficients.normalized();
      finding.u_amplitude = std::sqrt(variance * slope.dot(inverse * slope));
    }
  } else {
    finding.amplitude = coefficients[0];
    finding.u_amplitude = std::sqrt(variance * inverse(0, 0));
  }
  rotations.array() -= rotations.mean();
  finding.rms_rotation = rotations.norm() / std::sqrt(readings);
  return finding;
}

// Whether a joint that works can have it.
bool is_plausible_finding(const ModelFinding& finding) {
  const double size = std::abs(finding.amplitude);
  if (!(finding.rms_rotation <= max_rotation)) {
    return false;
  }
  switch (finding.effect) {
    case Effect::OncePerTurn:
    case Effect::TwicePerTurn: return size <= most_of(ParameterKind::Cosine1);
    case Effect::Gain: return size <= most_of(ParameterKind::Gain);
    case Effect::Expansion: return size <= most_of(ParameterKind::Expansion);
    case Effect::Gravity:
    case Effect::Drift:
    case Effect::TemperatureOffset: break;
  }
  return true;
}

// Takes the family out of the residuals and of all columns.
Remainder without_family(const EffectFamily& family, Searched rows) {
  const PivotedQr qr = factored(rows.columns.middleCols(family.first, family.columns));
  const Eigen::MatrixXd basis = basis_of(qr);
  rows.columns -= basis * (basis.transpose() * rows.columns);
  rows.residuals -= basis * (basis.transpose() * rows.residuals);
  rows.columns.middleCols(family.first, family.columns).setZero();
  for (auto column : rows.columns.colwise()) {
    if (column.norm() < least_seen) {
      column.setZero();
    }
  }
  for (ObservationRows& observation : rows.observations) {
    const auto own = basis.middleRows(observation.first, observation.hat.rows());
    observation.hat += own * own.transpose();
  }
  rows.degrees_of_freedom -= static_cast<double>(basis.cols());
  return Remainder(std::move(rows));
}

}  // namespace

ModelStudy search_residuals(const System& system, const ArmFit& fit, const Recording& recording) {
  ModelStudy study;
  if (fit.noise < rounding_noise) {
    return study;
  }
  const EffectColumns effects(system, recording);
  Remainder left(project_out_the_fit(system, fit, effects));
  if (left.rows.residuals.size() == 0) {
    return study;
  }
  study.readings = left.rows.readings();
  const auto variance = [&] { return left.rows.residuals.squaredNorm() / left.rows.degrees_of_freedom; };
  const double variance_of_fit = variance();
  while (study.findings.size() < max_findings) {
    std::vector<ModelTest> tests;
    std::vector<std::pair<const EffectFamily*, Share>> shares;
    for (const EffectFamily& candidate : effects.families()) {
      if (auto share = share_of(candidate, left)) {
        tests.push_back(share->test);
        shares.emplace_back(&candidate, std::move(*share));
      }
    }
    if (study.findings.empty()) {
      study.tests = tests;
      study.done = !tests.empty();
    }
    const double limit = study.false_alarms / static_cast<double>(std::max<std::size_t>(1, tests.size()));
    study.implausible = 0;
    const std::pair<const EffectFamily*, Share>* best = nullptr;
    std::optional<ModelFinding> finding;
    for (const auto& candidate : shares) {
      const auto& [family, share] = candidate;
      if (!(share.p < limit)) {
        study.implausible += share.test.p < limit ? 1 : 0;
        continue;
      }
      const ModelFinding found = finding_of(*family, share, left.rows);
      if (!is_plausible_finding(found)) {
        ++study.implausible;
      } else if (best == nullptr || share.evidence > best->second.evidence) {
        best = &candidate;
        finding = found;
      }
    }
    if (best == nullptr) {
      break;
    }
    study.findings.push_back(*finding);
    left = without_family(*best->first, std::move(left.rows));
    study.remaining_variance = variance() / variance_of_fit;
  }
  return study;
}

}  // namespace artcal
