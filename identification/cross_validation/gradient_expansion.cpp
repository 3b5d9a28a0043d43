#include "identification/cross_validation/gradient_expansion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <Eigen/LU>
#include <Eigen/QR>

#include "core/overloaded.h"
#include "core/parallel.h"
#include "identification/least_squares/rows.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

// Physical units, mm: far below a ball's radius, far above rounding.
constexpr double difference = 2e-3;
// Beyond, T is larger than what it replaces.
constexpr Eigen::Index max_kept = 40;
constexpr double least_independent = 1e-12;
constexpr std::size_t units_at_once = 64;
constexpr int max_refinements = 8;
constexpr double no_step = 1e-13;  // of the first

Eigen::Index pairs_of(Eigen::Index size) { return size * (size + 1) / 2; }

// The products of a step's entries in the order of the pairs, each as often as it is in [δ, δ].
Eigen::VectorXd pair_products(const Eigen::VectorXd& step) {
  Eigen::VectorXd products(pairs_of(step.size()));
  Eigen::Index pair = 0;
  for (Eigen::Index b = 0; b < step.size(); ++b) {
    for (Eigen::Index c = b; c < step.size(); ++c) {
      products[pair++] = (b == c ? 1.0 : 2.0) * step[b] * step[c];
    }
  }
  return products;
}

/// The kinematics and weights of one point along the expansion.
struct Displaced {
  Arm arm;
  std::vector<ForwardKinematics> kinematics_by_probe;
};

}  // namespace

/// The blocks that share a group's unknowns u, or one block without a group. Its rows are [u | g | residual].
class GradientExpansion::Unit {
 public:
  Unit(const System& system, const ArmFit& fit, const Noise& noise, const Weights& weights,
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

  /// `along[2·j]` and `along[2·j + 1]` are the arms displaced forward and back along the j-th number kept. False where
  /// the group is not determined.
  bool expand(const Displaced& at, const std::vector<Displaced>& along, Terms& terms) const {
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

 private:
  using FeatureWeightsList = std::map<int, FeatureWeights>;

  // ∂/∂g_k of the rows of g, the unknowns following, under the weights of the fit; and where weights depend on the
  // posture, the change of the rows of the fit, residuals and all, by that of the weights.
  void differentiate(const Displaced& at, const std::vector<Displaced>& along, Eigen::Index k,
                     const Eigen::MatrixXd& follow, Eigen::MatrixXd& bent, Eigen::MatrixXd& weighed) const {
    const Eigen::Index shared = system_.shared_size();
    RowMatrix moved[2], reweighed[2];
    for (const int back : {0, 1}) {
      const double by = back == 0 ? difference : -difference;
      Eigen::VectorXd values = values_;
      if (unknowns_ > 0) {
        values += by * follow.col(k);
      }
      Eigen::VectorXd numbers = shared_;
      if (k < shared) {
        numbers[k] += by;
      }
      const Displaced& there = k < shared ? at : along[static_cast<std::size_t>(2 * (k - shared) + back)];
      moved[back] = rows_at(there, values, numbers, {});
      if (noise_.encoder) {
        reweighed[back] = rows_at(at, values_, shared_, weights_of(there, values, numbers));
      }
    }
    const auto kept_rows = [&](const RowMatrix& rows) -> Eigen::MatrixXd {
      return rows.middleCols(unknowns_, kept_) + rows.leftCols(unknowns_) * follow;
    };
    bent = kept_rows((moved[0] - moved[1]) / (2.0 * difference));
    if (noise_.encoder) {
      const RowMatrix change = (reweighed[0] - reweighed[1]) / (2.0 * difference);
      weighed.resize(size_, kept_ + 1);
      weighed << kept_rows(change), change.rightCols<1>();
    }
  }

  [[nodiscard]] FeatureWeightsList weights_of(const Displaced& at, const Eigen::VectorXd& values,
                                              const Eigen::VectorXd& shared) const {
    FeatureWeightsList list;
    if (!noise_.encoder) {
      return list;
    }
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

  [[nodiscard]] const FeatureWeights& chosen(int f, const FeatureWeightsList& list) const {
    const auto own = list.find(f);
    return own != list.end() ? own->second : weights_.features[static_cast<std::size_t>(f)];
  }

  [[nodiscard]] RowMatrix rows_at(const Displaced& at, const Eigen::VectorXd& values, const Eigen::VectorXd& shared,
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
        weighted_rows(system_, readings.feature, chosen(readings.index, list), at.kinematics_by_probe,
                      readings.residual, 0, readings.feature.size(), out);
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

  const System& system_;
  const ArmFit& fit_;
  const Noise& noise_;
  const Weights& weights_;
  std::vector<const Block*> blocks_;
  int group_ = -1;
  Eigen::Index unknowns_ = 0;
  Eigen::Index kept_ = 0;
  Eigen::Index size_ = 0;
  Eigen::VectorXd values_, shared_;  // at the fit
};

std::optional<GradientExpansion> GradientExpansion::of(const System& system, const ArmFit& fit, const Noise& noise,
                                                       const Weights& weights, const std::vector<Block>& blocks,
                                                       const std::vector<std::optional<Placement>>& places,
                                                       int threads) {
  const Eigen::Index kept = system.shared_size() + system.arm_size();
  if (kept > max_kept) {
    return std::nullopt;
  }
  const auto displaced = [&](const Eigen::VectorXd& x) {
    Displaced at{system.arm_at(x.data()), {}};
    at.kinematics_by_probe = forward_kinematics_of(system, at.arm);
    return at;
  };
  const Eigen::VectorXd origin = Eigen::VectorXd::Zero(system.arm_size());
  const Displaced at = displaced(origin);
  std::vector<Displaced> along;
  for (Eigen::Index i = 0; i < origin.size(); ++i) {
    for (const double by : {difference, -difference}) {
      Eigen::VectorXd x = origin;
      x[i] = by;
      along.push_back(displaced(x));
    }
  }
  // The blocks of a group are one unit; each of the others is one by itself.
  std::vector<std::vector<const Block*>> units;
  std::vector<std::optional<Placement>> of_unit;
  std::map<int, std::size_t> unit_of_group;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].group >= 0) {
      const auto [entry, is_new] = unit_of_group.try_emplace(blocks[b].group, units.size());
      if (!is_new) {
        units[entry->second].push_back(&blocks[b]);
        of_unit[entry->second] = places[b] ? places[b] : of_unit[entry->second];
        continue;
      }
    }
    units.push_back({&blocks[b]});
    of_unit.push_back(places[b]);
  }
  GradientExpansion expansion;
  expansion.shared_ = system.shared_size();
  expansion.all_ = {Eigen::VectorXd::Zero(kept), Eigen::MatrixXd::Zero(kept, kept),
                    Eigen::MatrixXd::Zero(kept, pairs_of(kept))};
  std::map<Placement, KeptTerms> own;
  // A few at a time, which are summed in their order.
  for (std::size_t first = 0; first < units.size(); first += units_at_once) {
    const std::size_t count = std::min(units_at_once, units.size() - first);
    std::vector<Terms> terms(count);
    std::vector<char> is_regular(count, 1);
    parallel_for(count, threads, [&](std::size_t i) {
      is_regular[i] = Unit(system, fit, noise, weights, units[first + i]).expand(at, along, terms[i]) ? 1 : 0;
    });
    if (std::find(is_regular.begin(), is_regular.end(), 0) != is_regular.end()) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Terms& part = terms[i];
      expansion.all_.gradient += part.gradient;
      expansion.all_.slope += part.slope;
      expansion.all_.curvature += part.curvature;
      if (!of_unit[first + i]) {
        continue;
      }
      const KeptTerms kept_part{part.gradient, part.slope, part.curvature.cast<float>()};
      const auto [entry, is_new] = own.try_emplace(*of_unit[first + i], kept_part);
      if (!is_new) {
        entry->second.gradient += kept_part.gradient;
        entry->second.slope += kept_part.slope;
        entry->second.curvature += kept_part.curvature;
      }
    }
  }
  expansion.own_.assign(std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  return expansion;
}

std::optional<GradientExpansion::Minimum> GradientExpansion::without(const Placement& placement) const {
  const auto own = std::lower_bound(own_.begin(), own_.end(), placement,
                                    [](const auto& entry, const Placement& wanted) { return entry.first < wanted; });
  if (own == own_.end() || own->first != placement) {
    return std::nullopt;
  }
  const Eigen::VectorXd gradient = all_.gradient - own->second.gradient;
  const Eigen::MatrixXd slope = all_.slope - own->second.slope;
  const Eigen::MatrixXd curvature = all_.curvature - own->second.curvature.cast<double>();
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(slope);
  const auto length = [&](const Eigen::VectorXd& step) { return std::sqrt(std::abs(step.dot(slope * step))); };
  const Eigen::VectorXd first = -lu.solve(gradient);
  Eigen::VectorXd step = first;
  for (int i = 0; i < max_refinements; ++i) {
    const Eigen::VectorXd next = -lu.solve(gradient + 0.5 * curvature * pair_products(step));
    const double moved = length(next - step);
    step = next;
    if (!step.allFinite()) {
      return std::nullopt;
    }
    if (moved <= no_step * length(first)) {
      break;
    }
  }
  const double whole = length(first);
  const double bent = length(step - first);
  return Minimum{step.tail(step.size() - shared_), whole > 0.0 ? bent * bent / whole : 0.0};
}

}  // namespace artcal
