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

namespace artcal {
namespace {

constexpr int max_findings = 8;
constexpr double least_noise = 1e-6;  // mm; below, what is left is rounding

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

std::optional<Share> share_of(const EffectFamily& family, const Eigen::MatrixXd& columns,
                              const Eigen::VectorXd& residuals, double degrees_of_freedom) {
  const Eigen::MatrixXd own = columns.middleCols(family.first, family.columns);
  const PivotedQr qr = factored(own);
  const auto rank = static_cast<int>(qr.rank());
  const double left = degrees_of_freedom - rank;
  if (rank == 0 || own.norm() < least_seen || left < 10.0) {
    return std::nullopt;
  }
  const double whole = residuals.squaredNorm();
  const auto f_of = [&](double explained) { return explained / rank / ((whole - explained) / left); };
  const double f = f_of(explained_by(qr, residuals));
  Share share{{family.effect, family.joint, rank, f, f_probability_above(f, rank, left)},
              physical_columns(family, columns, residuals)};
  if (!share.columns.empty()) {
    // Fewer columns explain less: with the degrees of freedom of all of them the test keeps its size.
    const double explained = explained_by(factored(columns(Eigen::all, share.columns)), residuals);
    share.p = f_probability_above(f_of(explained), rank, left);
    share.evidence =
        degrees_of_freedom * std::log1p(explained / (whole - explained)) - rank * std::log(degrees_of_freedom);
  }
  return share;
}

ModelFinding finding_of(const EffectFamily& family, const Share& share, const Eigen::MatrixXd& columns,
                        const Eigen::VectorXd& residuals, const Searched& searched) {
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
bool is_plausible(const ModelFinding& finding) {
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
  while (study.findings.size() < max_findings) {
    std::vector<ModelTest> tests;
    std::vector<std::pair<const EffectFamily*, Share>> shares;
    for (const EffectFamily& candidate : effects.families()) {
      if (auto share = share_of(candidate, columns, residuals, degrees_of_freedom)) {
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
      const ModelFinding found = finding_of(*family, share, columns, residuals, searched);
      if (!is_plausible(found)) {
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
    degrees_of_freedom -= best->second.test.columns;
    remove_family(*best->first, columns, residuals);
  }
  return study;
}

}  // namespace artcal
