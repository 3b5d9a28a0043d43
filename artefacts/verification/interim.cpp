#include "artefacts/verification/interim.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace artcal {
namespace {

using Key = std::tuple<Quantity, std::string, std::string, std::string, std::string>;
using Groups = std::map<Key, std::vector<const TestValue*>>;

constexpr double normal_95 = 1.96;

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
  [[nodiscard]] double deviation() const { return freedom > 0 ? std::sqrt(squares / freedom) : 0.0; }
  // Student's factor to its first term (Cornish-Fisher).
  [[nodiscard]] double coverage() const {
    return freedom > 0 ? normal_95 * (1.0 + (normal_95 * normal_95 + 1.0) / (4.0 * freedom)) : 0.0;
  }
};

double u_without_shared(const TestValue& value, bool same_certificate) {
  Budget budget = value.budget;
  budget.calibration = same_certificate ? 0.0 : budget.calibration;
  return budget.total();
}

}  // namespace

bool InterimCheck::any_significant() const {
  return std::any_of(drifts.begin(), drifts.end(), [](const Drift& drift) { return drift.significant; });
}

bool InterimCheck::any_told() const {
  return std::any_of(drifts.begin(), drifts.end(), [](const Drift& drift) { return drift.degrees_of_freedom > 0; });
}

InterimCheck compare(const std::vector<TestValue>& now, const std::vector<TestValue>& then) {
  InterimCheck check;
  const Groups before = grouped(then);
  const Groups after = grouped(now);
  std::map<Quantity, Scatter> scatter;
  for (const Groups* groups : {&before, &after}) {
    for (const auto& [key, values] : *groups) {
      scatter[std::get<0>(key)].add(values);
    }
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
    const Scatter& of_quantity = scatter[b.quantity];
    drift.degrees_of_freedom = of_quantity.freedom;
    drift.repeatability = of_quantity.deviation();
    drift.coverage = of_quantity.coverage();
    const double of_means = drift.repeatability * std::sqrt(1.0 / drift.repeats_then + 1.0 / drift.repeats_now);
    drift.u = std::hypot(of_means, u_without_shared(a, same_certificate), u_without_shared(b, same_certificate));
    drift.significant = drift.degrees_of_freedom > 0 && std::abs(drift.drift) > drift.coverage * drift.u;
    check.drifts.push_back(drift);
  }
  return check;
}

}  // namespace artcal
