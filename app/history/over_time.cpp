#include "app/history/over_time.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "core/statistics.h"

namespace artcal {
namespace {

using Key = std::tuple<std::string, Quantity, std::string, std::string, std::string, std::string>;

/// What repeats of a value add up to.
struct Repeats {
  const TestValue* first = nullptr;
  int count = 0;
  double sum = 0.0;

  void add(const TestValue& value) {
    first = first != nullptr ? first : &value;
    ++count;
    sum += value.value;
  }
  [[nodiscard]] double mean() const { return sum / count; }
};

/// Of the repeats of one quantity, about the means of their values.
struct Scatter {
  double squares = 0.0;
  int freedom = 0;
  [[nodiscard]] double variance() const { return freedom > 0 ? squares / freedom : 0.0; }
};

Key key_of(const std::string& standard, const TestValue& value) {
  return {standard, value.quantity, value.artefact, value.placement, value.first, value.second};
}

void add_points(std::map<Key, std::vector<ValueThen>>& points, const PastVerification& past, std::size_t index) {
  std::map<Key, Repeats> repeats;
  for (const TestValue& value : past.values) {
    if (!value.set_aside) {
      repeats[key_of(past.standard, value)].add(value);
    }
  }
  std::map<Quantity, Scatter> scatter;
  for (const TestValue& value : past.values) {
    if (!value.set_aside) {
      const double off = value.value - repeats.at(key_of(past.standard, value)).mean();
      scatter[value.quantity].squares += off * off;
    }
  }
  for (const auto& [key, of_value] : repeats) {
    scatter[std::get<1>(key)].freedom += of_value.count - 1;
  }
  for (const auto& [key, of_value] : repeats) {
    const Scatter& of_quantity = scatter[std::get<1>(key)];
    const double u_of_mean = std::sqrt(of_quantity.variance() / of_value.count);
    Budget budget = of_value.first->budget;
    budget.points = of_quantity.freedom > 0 ? 0.0 : budget.points;  // it is in the scatter of the repeats
    const std::array<UncertaintyComponent, 2> components{
        {{budget.total(), budget.degrees_of_freedom()},
         {u_of_mean, of_quantity.freedom > 0 ? of_quantity.freedom : std::numeric_limits<double>::infinity()}}};
    points[key].push_back({index, of_value.count, of_value.mean(), std::hypot(budget.total(), u_of_mean),
                           stated_coverage_factor(effective_degrees_of_freedom(components)), of_value.first->limit});
  }
}

}  // namespace

std::vector<ValueOverTime> values_over_time(const ArmHistory& history) {
  std::map<Key, std::vector<ValueThen>> points;
  for (std::size_t i = 0; i < history.verifications.size(); ++i) {
    add_points(points, history.verifications[i], i);
  }
  std::vector<ValueOverTime> values;
  for (auto& [key, of_value] : points) {
    const auto& [standard, quantity, artefact, placement, first, second] = key;
    values.push_back({standard, quantity, artefact, placement, first, second, std::move(of_value)});
  }
  return values;
}

std::vector<WorstOverTime> worst_over_time(const ArmHistory& history) {
  std::map<std::pair<std::string, Quantity>, std::vector<WorstOverTime::Point>> points;
  for (std::size_t i = 0; i < history.verifications.size(); ++i) {
    const PastVerification& past = history.verifications[i];
    std::map<Quantity, const TestValue*> worst;
    for (const TestValue& value : past.values) {
      const TestValue*& most = worst[value.quantity];
      if (!value.set_aside && (most == nullptr || severity(value) > severity(*most))) {
        most = &value;
      }
    }
    for (const auto& [quantity, value] : worst) {
      if (value != nullptr) {
        points[{past.standard, quantity}].push_back({i, value});
      }
    }
  }
  std::vector<WorstOverTime> all;
  for (auto& [key, of_quantity] : points) {
    all.push_back({key.first, key.second, std::move(of_quantity)});
  }
  return all;
}

}  // namespace artcal
