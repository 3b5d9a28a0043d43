#include "artefacts/verification/interim.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/statistics.h"

namespace artcal {
namespace {

using Key = std::tuple<Quantity, std::string, std::string, std::string, std::string>;
using Groups = std::map<Key, std::vector<const TestValue*>>;

constexpr double chance_of_unequal = 0.05;  // of calling equal scatters different
// The same where it is said of the arm: a bumped arm may scatter about the same means.
constexpr double chance_of_changed = 0.001;

Groups grouped(const std::vector<TestValue>& values) {
  Groups groups;
  for (const TestValue& value : values) {
    if (!value.set_aside) {
      groups[{value.quantity, value.artefact, value.placement, value.first, value.second}].push_back(&value);
    }
  }
  return groups;
}

double mean_of(const std::vector<const TestValue*>& values) {
  double sum = 0.0;
  for (const TestValue* value : values) {
    sum += value->value;
  }
  return sum / static_cast<double>(values.size());
}

/// Squares of values about the means of their groups, and their degrees of freedom.
struct Scatter {
  double squares = 0.0;
  int freedom = 0;

  void add(const std::vector<const TestValue*>& values) {
    const double mean = mean_of(values);
    for (const TestValue* value : values) {
      squares += (value->value - mean) * (value->value - mean);
    }
    freedom += static_cast<int>(values.size()) - 1;
  }
  [[nodiscard]] double variance() const { return freedom > 0 ? squares / freedom : 0.0; }
};

/// The scatter of one quantity in both sessions.
struct ScatterOfBoth {
  Scatter then, now;

  [[nodiscard]] Scatter pooled() const { return {then.squares + now.squares, then.freedom + now.freedom}; }

  // Pooling two variances that differ accuses an arm that has not moved: F says whether they do.
  [[nodiscard]] bool differ(double chance = chance_of_unequal) const {
    if (then.freedom == 0 || now.freedom == 0 || then.variance() == now.variance()) {
      return false;
    }
    const bool now_is_larger = now.variance() > then.variance();
    const Scatter& larger = now_is_larger ? now : then;
    const Scatter& smaller = now_is_larger ? then : now;
    const double limit = f_quantile_above(0.5 * chance, larger.freedom, smaller.freedom);
    return larger.variance() > limit * smaller.variance();
  }

  /// Whether the repeats scatter more now than chance allows (F test).
  [[nodiscard]] bool has_grown() const { return now.variance() > then.variance() && differ(chance_of_changed); }

  // Of the difference of two means.
  [[nodiscard]] std::vector<UncertaintyComponent> components(int repeats_then, int repeats_now) const {
    if (differ()) {
      return {{std::sqrt(then.variance() / repeats_then), static_cast<double>(then.freedom)},
              {std::sqrt(now.variance() / repeats_now), static_cast<double>(now.freedom)}};
    }
    const Scatter both = pooled();
    if (both.freedom == 0) {
      return {};
    }
    return {{std::sqrt(both.variance() * (1.0 / repeats_then + 1.0 / repeats_now)), static_cast<double>(both.freedom)}};
  }
};

double u_without_shared(const TestValue& value, bool same_certificate) {
  Budget budget = value.budget;
  budget.calibration = same_certificate ? 0.0 : budget.calibration;
  budget.points = 0.0;  // it is in the scatter of the repeats
  return budget.total();
}

double combined(const std::vector<UncertaintyComponent>& components) {
  double variance = 0.0;
  for (const UncertaintyComponent& component : components) {
    variance += component.u * component.u;
  }
  return std::sqrt(variance);
}

}  // namespace

bool InterimCheck::any_significant() const {
  return std::any_of(drifts.begin(), drifts.end(), [](const Drift& drift) { return drift.significant; });
}

bool InterimCheck::any_judged() const {
  return std::any_of(drifts.begin(), drifts.end(), [](const Drift& drift) { return drift.degrees_of_freedom > 0; });
}

InterimCheck compare(const std::vector<TestValue>& now, const std::vector<TestValue>& then) {
  InterimCheck check;
  const Groups before = grouped(then);
  const Groups after = grouped(now);
  std::map<Quantity, ScatterOfBoth> scatter;
  for (const auto& [key, values] : before) {
    scatter[std::get<0>(key)].then.add(values);
  }
  for (const auto& [key, values] : after) {
    scatter[std::get<0>(key)].now.add(values);
  }
  for (const auto& [key, values] : after) {
    const auto earlier = before.find(key);
    if (earlier == before.end()) {
      check.not_compared.push_back(label_of(*values.front()));
      continue;
    }
    const TestValue& a = *earlier->second.front();
    const TestValue& b = *values.front();
    const bool same_certificate = a.certified == b.certified && a.budget.calibration == b.budget.calibration;
    Drift drift;
    drift.quantity = b.quantity;
    drift.artefact = b.artefact;
    drift.placement = b.placement;
    drift.first = b.first;
    drift.second = b.second;
    drift.repeats_then = static_cast<int>(earlier->second.size());
    drift.repeats_now = static_cast<int>(values.size());
    drift.then = mean_of(earlier->second);
    drift.now = mean_of(values);
    drift.drift = drift.now - drift.then;
    const ScatterOfBoth& of_quantity = scatter[b.quantity];
    drift.degrees_of_freedom = of_quantity.pooled().freedom;
    drift.repeatability = std::sqrt(of_quantity.pooled().variance());
    auto components = of_quantity.components(drift.repeats_then, drift.repeats_now);
    components.push_back({u_without_shared(a, same_certificate)});
    components.push_back({u_without_shared(b, same_certificate)});
    drift.u = combined(components);
    if (drift.degrees_of_freedom > 0) {
      drift.effective_degrees_of_freedom = effective_degrees_of_freedom(components);
    }
    check.drifts.push_back(drift);
  }
  const auto told = static_cast<std::size_t>(std::count_if(
      check.drifts.begin(), check.drifts.end(), [](const Drift& drift) { return drift.degrees_of_freedom > 0; }));
  for (Drift& drift : check.drifts) {
    if (drift.degrees_of_freedom > 0) {
      drift.coverage = significance_factor(told, drift.effective_degrees_of_freedom);
      drift.significant = std::abs(drift.drift) > drift.coverage * drift.u || scatter[drift.quantity].has_grown();
    }
  }
  return check;
}

}  // namespace artcal
