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

// Adds squares about the group's mean and their degrees of freedom.
void pool(const std::vector<const TestValue*>& values, double& squares, int& freedom) {
  const double mean = mean_of(values);
  for (const TestValue* value : values) {
    squares += (value->value - mean) * (value->value - mean);
  }
  freedom += static_cast<int>(values.size()) - 1;
}

double u_without_shared(const TestValue& value, bool same_certificate) {
  Budget budget = value.budget;
  budget.calibration = same_certificate ? 0.0 : budget.calibration;
  return budget.total();
}

}  // namespace

bool InterimCheck::any_significant() const {
  return std::any_of(drifts.begin(), drifts.end(), [](const Drift& drift) { return drift.significant; });
}

InterimCheck compare(const std::vector<TestValue>& now, const std::vector<TestValue>& then) {
  InterimCheck check;
  const Groups before = grouped(then);
  const Groups after = grouped(now);
  double squares = 0.0;
  for (const Groups* groups : {&before, &after}) {
    for (const auto& [key, values] : *groups) {
      pool(values, squares, check.degrees_of_freedom);
    }
  }
  const int freedom = check.degrees_of_freedom;
  if (freedom > 0) {
    check.repeatability = std::sqrt(squares / freedom);
    check.coverage = normal_95 * (1.0 + (normal_95 * normal_95 + 1.0) / (4.0 * freedom));  // Student, first term
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
    Drift drift{b.quantity,
                b.artefact,
                b.placement,
                b.first,
                b.second,
                static_cast<int>(earlier->second.size()),
                static_cast<int>(values.size()),
                mean_of(earlier->second),
                mean_of(values),
                0.0,
                0.0,
                false};
    drift.drift = drift.now - drift.then;
    const double scatter = check.repeatability * std::sqrt(1.0 / drift.repeats_then + 1.0 / drift.repeats_now);
    drift.u = std::hypot(scatter, u_without_shared(a, same_certificate), u_without_shared(b, same_certificate));
    drift.significant = freedom > 0 && std::abs(drift.drift) > check.coverage * drift.u;
    check.drifts.push_back(drift);
  }
  return check;
}

}  // namespace artcal
