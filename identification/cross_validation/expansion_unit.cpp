#include "identification/cross_validation/expansion_unit.h"

#include <utility>

#include <Eigen/QR>

#include "core/overloaded.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

constexpr double least_independent = 1e-12;

}  // namespace

Eigen::Index pairs_of(Eigen::Index size) { return size * (size + 1) / 2; }

ExpansionUnit::ExpansionUnit(const System& system, const ArmFit& fit, const Noise& noise, const Weights& weights,
                             std::vector<const Block*> blocks)
    : system_(system), fit_(fit), noise_(noise), weights_(weights), blocks_(std::move(blocks)) {
  const Constraints& constraints = *system.constraints;
  group_ = blocks_.front()->group;
  unknowns_ = blocks_.front()->unknowns;
  kept_ = system.shared_size() + system.arm_size();
  for (const Block* block : blocks_) {
    for (const int f : block->features) {
      size_ += constraints.features[f].size() * constraints.features[f].dimension();
    }
    size_ += static_cast<Eigen::Index>(block->distances.size());
    size_ += block->has_certificate ? block->parameters.size : 0;
  }
  if (group_ >= 0) {
    values_ = fit.unknowns.groups[group_].values;
  }
  shared_ = fit.unknowns.shared;
}

bool ExpansionUnit::expand(const DisplacedArm& at, const std::vector<DisplacedArm>& along,
                           ExpansionTerms& terms) const {
  const Eigen::Index residual = unknowns_ + kept_;
  const RowMatrix here = rows_at(at, values_, shared_, {});  // under the weights of the fit
  const Eigen::VectorXd r = here.col(residual);
  Eigen::MatrixXd follow(unknowns_, kept_);  // L
  if (unknowns_ > 0) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(here.leftCols(unknowns_));
    qr.setThreshold(least_independent);
    if (qr.rank() < unknowns_) {
      return false;
    }
    follow = -qr.solve(here.middleCols(unknowns_, kept_));
  }
  const Eigen::MatrixXd j = here.middleCols(unknowns_, kept_) + here.leftCols(unknowns_) * follow;
  terms.gradient = j.transpose() * r;
  terms.slope = j.transpose() * j;
  terms.curvature.resize(kept_, pairs_of(kept_));
  // Of each direction b: Σ ∂²r_ab·r_c at (a, c), and Σ ω·∂ω_b·r_a·r_c, which counts twice for weights ω².
  std::vector<Eigen::MatrixXd> bends(static_cast<std::size_t>(kept_));
  std::vector<Eigen::MatrixXd> weighings(static_cast<std::size_t>(kept_));
  for (Eigen::Index k = 0; k < kept_; ++k) {
    Eigen::MatrixXd bent, weighed;
    differentiate(at, along, k, follow, bent, weighed);
    bends[static_cast<std::size_t>(k)] = bent.transpose() * j;
    terms.slope.col(k) += bent.transpose() * r;
    if (noise_.encoder) {
      terms.slope.col(k) += weighed.leftCols(kept_).transpose() * r + j.transpose() * weighed.col(kept_);
      weighings[static_cast<std::size_t>(k)] = 2.0 * j.transpose() * weighed.leftCols(kept_);
    }
  }
  Eigen::Index pair = 0;
  for (Eigen::Index b = 0; b < kept_; ++b) {
    for (Eigen::Index c = b; c < kept_; ++c) {
      auto column = terms.curvature.col(pair++);
      column = bends[b].col(c) + bends[c].col(b) + bends[c].row(b).transpose();
      if (noise_.encoder) {
        column += weighings[b].col(c) + weighings[c].col(b);
      }
    }
  }
  return true;
}

void ExpansionUnit::differentiate(const DisplacedArm& at, const std::vector<DisplacedArm>& along, Eigen::Index k,
                                  const Eigen::MatrixXd& follow, Eigen::MatrixXd& bent,
                                  Eigen::MatrixXd& weighed) const {
  const Eigen::Index shared = system_.shared_size();
  RowMatrix moved[2], reweighed[2];
  for (const int back : {0, 1}) {
    const double by = back == 0 ? expansion_step : -expansion_step;
    Eigen::VectorXd values = values_;
    if (unknowns_ > 0) {
      values += by * follow.col(k);
    }
    Eigen::VectorXd numbers = shared_;
    if (k < shared) {
      numbers[k] += by;
    }
    const DisplacedArm& there = k < shared ? at : along[static_cast<std::size_t>(2 * (k - shared) + back)];
    moved[back] = rows_at(there, values, numbers, {});
    if (noise_.encoder) {
      reweighed[back] = rows_at(at, values_, shared_, weights_of(there, values, numbers));
    }
  }
  const auto kept_rows = [&](const RowMatrix& rows) -> Eigen::MatrixXd {
    return rows.middleCols(unknowns_, kept_) + rows.leftCols(unknowns_) * follow;
  };
  bent = kept_rows((moved[0] - moved[1]) / (2.0 * expansion_step));
  if (noise_.encoder) {
    const RowMatrix change = (reweighed[0] - reweighed[1]) / (2.0 * expansion_step);
    weighed.resize(size_, kept_ + 1);
    weighed << kept_rows(change), change.rightCols<1>();
  }
}

ExpansionUnit::FeatureWeightsList ExpansionUnit::weights_of(const DisplacedArm& at, const Eigen::VectorXd& values,
                                                            const Eigen::VectorXd& shared) const {
  FeatureWeightsList list;
  const GroupReference none;
  const GroupReference& reference = group_ < 0 ? none : fit_.unknowns.groups[group_].reference;
  for (const Block* block : blocks_) {
    for (const int f : block->features) {
      const FeatureConstraint& feature = system_.constraints->features[f];
      const FeatureResidual residual(feature, reference, values.data(), shared.data());
      list.emplace(f, posture_weights(system_, feature, residual, at.kinematics_by_probe, at.arm, *noise_.encoder,
                                      *noise_.probing));
    }
  }
  return list;
}

const FeatureWeights& ExpansionUnit::chosen(int f, const FeatureWeightsList& list) const {
  const auto own = list.find(f);
  return own != list.end() ? own->second : weights_.features[static_cast<std::size_t>(f)];
}

RowMatrix ExpansionUnit::rows_at(const DisplacedArm& at, const Eigen::VectorXd& values, const Eigen::VectorXd& shared,
                                 const FeatureWeightsList& list) const {
  const Constraints& constraints = *system_.constraints;
  RowMatrix rows = RowMatrix::Zero(size_, unknowns_ + kept_ + 1);
  Eigen::Index next = 0;
  const GroupReference none;
  for (const Block* block : blocks_) {
    const BlockPoint point{group_ < 0 ? none : fit_.unknowns.groups[group_].reference, values.data(), shared.data()};
    const auto add_readings = [&](const FeatureReadings& readings) {
      double* row = rows.row(next).data();
      const RowsOut out{rows.cols(),
                        row + unknowns_ + kept_,
                        row + unknowns_ + system_.shared_size(),
                        unknowns_ > 0 ? row : nullptr,
                        system_.shared_size() > 0 ? row + unknowns_ : nullptr,
                        0};
      weighted_rows(system_, readings.feature, chosen(readings.index, list), at.kinematics_by_probe, readings.residual,
                    0, readings.feature.size(), out);
      next += readings.feature.size() * readings.feature.dimension();
    };
    const auto add_distance = [&](const BindingDistance& distance) {
      rows(next, unknowns_ + kept_) = weighted_distance(
          distance.distance, constraints, weights_.distances[distance.index], point.values, rows.row(next).data());
      ++next;
    };
    const auto add_certificate = [&](const CertifiedParameter& certified) {
      const double weight = weights_.shared[certified.index];
      rows(next, unknowns_ + certified.index) = weight;
      rows(next, unknowns_ + kept_) = weighted_shared(certified.parameter, weight, shared[certified.index]);
      ++next;
    };
    for_each_observation(constraints, *block, point, Overloaded{add_readings, add_distance, add_certificate});
  }
  return rows;
}

}  // namespace artcal
