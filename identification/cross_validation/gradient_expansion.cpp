#include "identification/cross_validation/gradient_expansion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <Eigen/LU>

#include "core/parallel.h"

namespace artcal {
namespace {

// Beyond, T is larger than what it replaces.
constexpr Eigen::Index max_kept = 40;
constexpr std::size_t units_at_once = 64;
constexpr int max_refinements = 8;
constexpr double no_step = 1e-13;  // of the first

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

}  // namespace

std::optional<GradientExpansion> GradientExpansion::of(const System& system, const ArmFit& fit, const Noise& noise,
                                                       const Weights& weights, const std::vector<Block>& blocks,
                                                       const std::vector<std::optional<Placement>>& places,
                                                       int threads) {
  const Eigen::Index kept = system.shared_size() + system.arm_size();
  if (kept > max_kept) {
    return std::nullopt;
  }
  const auto displaced = [&](const Eigen::VectorXd& x) {
    DisplacedArm at{system.arm_at(x.data()), {}};
    at.kinematics_by_probe = forward_kinematics_of(system, at.arm);
    return at;
  };
  const Eigen::VectorXd origin = Eigen::VectorXd::Zero(system.arm_size());
  const DisplacedArm at = displaced(origin);
  std::vector<DisplacedArm> along;
  for (Eigen::Index i = 0; i < origin.size(); ++i) {
    for (const double by : {expansion_step, -expansion_step}) {
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
    std::vector<ExpansionTerms> terms(count);
    std::vector<char> is_regular(count, 1);
    parallel_for(count, threads, [&](std::size_t i) {
      is_regular[i] = ExpansionUnit(system, fit, noise, weights, units[first + i]).expand(at, along, terms[i]) ? 1 : 0;
    });
    if (std::find(is_regular.begin(), is_regular.end(), 0) != is_regular.end()) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const ExpansionTerms& part = terms[i];
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
