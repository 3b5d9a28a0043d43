#include "fitting/robust/distinct_points.h"

#include <numeric>

#include "core/coincidence/coincident_columns.h"
#include "fitting/chosen_points.h"

namespace artcal::fitting {
namespace {

// Which point differs from all before it; −1 for weight zero. Nothing where all differ and have a weight.
std::vector<int> numbers_of(const Points& points, const Eigen::VectorXd& weights) {
  const auto repeated = repeated_columns(points);
  if (repeated.empty() && (weights.array() != 0.0).all()) {
    return {};
  }
  const auto count = static_cast<std::size_t>(points.cols());
  std::vector<std::size_t> equal(count);  // the first that is
  std::iota(equal.begin(), equal.end(), std::size_t{0});
  for (const RepeatedColumn& one : repeated) {
    equal[static_cast<std::size_t>(one.column)] = static_cast<std::size_t>(one.first);
  }
  std::vector<int> number_of_equal(count, -1);
  std::vector<int> numbers(count, -1);
  int next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (weights.size() == 0 || weights(static_cast<Eigen::Index>(i)) != 0.0) {
      int& number = number_of_equal[equal[i]];
      number = number < 0 ? next++ : number;
      numbers[i] = number;
    }
  }
  return numbers;
}

// The first point of each number.
std::vector<int> first_of_each(const std::vector<int>& numbers) {
  std::vector<int> first;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == static_cast<int>(first.size())) {
      first.push_back(static_cast<int>(i));
    }
  }
  return first;
}

}  // namespace

DistinctPoints::DistinctPoints(const Points& points, const Eigen::VectorXd& weights)
    : of_(numbers_of(points, weights)),
      copied_(chosen_points(points, first_of_each(of_))),
      points_(of_.empty() ? points : Points(copied_)),
      weights_(weights.size() == 0 || of_.empty() ? weights : Eigen::VectorXd(weights(first_of_each(of_)))) {}

}  // namespace artcal::fitting
