#include "identification/monte_carlo/distribution.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace artcal {
namespace {

constexpr double unit = 0x1.0p32;             // deviations are summed in 2⁻³² of a scale
constexpr double farthest_scales = 0x1.0p16;  // scales: what is further off counts as this far

}  // namespace

Distribution::Distribution(Contents contents)
    : ruler_(contents.ruler),
      count_(contents.count),
      below_(contents.below),
      above_(contents.above),
      sum_(contents.sum),
      squares_(contents.squares),
      counts_(std::move(contents.counts)) {
  assert(counts_.size() == cells);
}

void Distribution::add(double value) {
  const double scaled = std::clamp((value - ruler_.centre) / ruler_.scale, -farthest_scales, farthest_scales);
  ++count_;
  const auto rounded = static_cast<Sum>(std::llrint(scaled * unit));
  sum_ += rounded;
  squares_ += rounded * rounded;
  const double cell = std::floor((scaled + scales_to_a_side) * cells_per_scale);
  if (cell < 0.0) {
    ++below_;
  } else if (cell >= cells) {
    ++above_;
  } else {
    ++counts_[static_cast<std::size_t>(cell)];
  }
}

void Distribution::add(const Distribution& other) {
  count_ += other.count_;
  below_ += other.below_;
  above_ += other.above_;
  sum_ += other.sum_;
  squares_ += other.squares_;
  std::transform(counts_.begin(), counts_.end(), other.counts_.begin(), counts_.begin(), std::plus<>());
}

double Distribution::value_at(double cell) const {
  return ruler_.centre + ruler_.scale * (cell / cells_per_scale - scales_to_a_side);
}

double Distribution::mean() const {
  const double scaled = static_cast<double>(sum_) / unit / static_cast<double>(count_);
  return ruler_.centre + ruler_.scale * scaled;
}

double Distribution::deviation() const {
  const auto n = static_cast<double>(count_);
  const double sum = static_cast<double>(sum_) / unit;
  const double squares = static_cast<double>(squares_) / (unit * unit);
  return ruler_.scale * std::sqrt(std::max(0.0, squares - sum * sum / n) / (n - 1.0));
}

std::optional<double> Distribution::quantile(double p) const {
  const double wanted = p * static_cast<double>(count_);
  auto sum = static_cast<double>(below_);
  if (count_ == 0 || wanted < sum) {
    return std::nullopt;
  }
  for (int cell = 0; cell < cells; ++cell) {
    const auto here = static_cast<double>(counts_[static_cast<std::size_t>(cell)]);
    if (here > 0.0 && sum + here >= wanted) {
      return value_at(cell + (wanted - sum) / here);
    }
    sum += here;
  }
  return std::nullopt;
}

std::optional<Interval> Distribution::symmetric(double probability) const {
  const auto low = quantile(0.5 * (1.0 - probability));
  const auto high = quantile(0.5 * (1.0 + probability));
  return low && high ? std::optional(Interval{*low, *high}) : std::nullopt;
}

// From the lower end of each cell upwards: both ends only move up.
std::optional<Interval> Distribution::shortest(double probability) const {
  std::optional<Interval> best;
  const auto n = static_cast<double>(count_);
  const double wanted = probability * n;
  auto left_out = static_cast<double>(below_);
  double inside = 0.0;  // of the cells [first, last)
  int last = 0;
  for (int first = 0; first < cells; ++first) {
    if (last < first) {
      last = first;
      inside = 0.0;
    }
    while (last < cells && inside + static_cast<double>(counts_[static_cast<std::size_t>(last)]) < wanted) {
      inside += static_cast<double>(counts_[static_cast<std::size_t>(last++)]);
    }
    if (last == cells || left_out + wanted > n) {
      break;
    }
    const double within = (wanted - inside) / static_cast<double>(counts_[static_cast<std::size_t>(last)]);
    const Interval candidate{value_at(first), value_at(last + within)};
    if (!best || candidate.high - candidate.low < best->high - best->low) {
      best = candidate;
    }
    const auto leaving = static_cast<double>(counts_[static_cast<std::size_t>(first)]);
    left_out += leaving;
    inside -= first < last ? leaving : 0.0;
  }
  return best;
}

double Distribution::error_of_mean() const { return deviation() / std::sqrt(static_cast<double>(count_)); }

// Var(s²) = (μ4 − σ⁴)/n, and s = √s².
double Distribution::error_of_deviation() const {
  const double middle = (mean() - ruler_.centre) / ruler_.scale;
  const double s = deviation() / ruler_.scale;
  double fourth = 0.0;
  const auto far = static_cast<double>(below_ + above_);
  for (int cell = 0; cell < cells; ++cell) {
    const double z = (cell + 0.5) / cells_per_scale - scales_to_a_side - middle;
    fourth += static_cast<double>(counts_[static_cast<std::size_t>(cell)]) * z * z * z * z;
  }
  fourth += far * std::pow(scales_to_a_side, 4);
  const auto n = static_cast<double>(count_);
  const double variance = std::max(0.0, fourth / n - s * s * s * s) / n;
  return s > 0.0 ? ruler_.scale * std::sqrt(variance) / (2.0 * s) : 0.0;
}

std::optional<double> Distribution::error_of_quantile(double p) const {
  const double share = std::sqrt(p * (1.0 - p) / static_cast<double>(count_));
  const auto low = quantile(std::max(0.0, p - share));
  const auto high = quantile(std::min(1.0, p + share));
  return low && high ? std::optional(0.5 * (*high - *low)) : std::nullopt;
}

}  // namespace artcal
