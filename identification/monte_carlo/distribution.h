#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace artcal {

/// Where a value is counted: deviations from `centre` in units of `scale`, which is about its standard deviation.
struct Ruler {
  double centre = 0.0;
  double scale = 1.0;  ///< above zero
};

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// The distribution of one quantity over any number of trials in memory that does not grow with them: sums of
/// deviations and of their squares, and a histogram. All are integers, so that neither the order of the trials nor how
/// they were shared among threads and machines changes a bit.
///
/// Resolution: deviations are rounded to 2⁻³² of the ruler's scale before they are summed; a histogram's cell is 1/256
/// of the scale, and quantiles are interpolated within it. The histogram reaches 16 scales to both sides; what lies
/// beyond is counted there, and a quantile that falls there is absent.
class Distribution {
 public:
  static constexpr int cells_per_scale = 256;
  static constexpr int scales_to_a_side = 16;
  static constexpr int cells = 2 * scales_to_a_side * cells_per_scale;
  __extension__ typedef __int128 Sum;

  explicit Distribution(const Ruler& ruler) : ruler_(ruler), counts_(cells, 0) {}

  void add(double value);
  /// REQUIRES: the same ruler.
  void add(const Distribution& other);

  [[nodiscard]] const Ruler& ruler() const { return ruler_; }
  [[nodiscard]] std::int64_t count() const { return count_; }
  [[nodiscard]] double mean() const;
  /// Standard deviation, n − 1. REQUIRES: two values.
  [[nodiscard]] double deviation() const;
  /// The value that a share `p` of the values stays below.
  [[nodiscard]] std::optional<double> quantile(double p) const;
  /// Probabilistically symmetric (JCGM 101 §5.3.3) and shortest (§5.3.4) coverage interval.
  [[nodiscard]] std::optional<Interval> symmetric(double probability) const;
  [[nodiscard]] std::optional<Interval> shortest(double probability) const;

  /// Standard deviations that mean, standard deviation and quantile themselves have from the number of values: of the
  /// mean u/√n, of the standard deviation by the fourth moment, of a quantile half the distance between those at
  /// p ± √(p(1 − p)/n), the values' order statistics being binomial.
  [[nodiscard]] double error_of_mean() const;
  [[nodiscard]] double error_of_deviation() const;
  [[nodiscard]] std::optional<double> error_of_quantile(double p) const;

  /// Everything it holds, to write it down and to have it back.
  struct Contents {
    Ruler ruler;
    std::int64_t count = 0, below = 0, above = 0;
    Sum sum = 0, squares = 0;
    std::vector<std::int64_t> counts;  ///< of the cells
  };
  [[nodiscard]] Contents contents() const { return {ruler_, count_, below_, above_, sum_, squares_, counts_}; }
  explicit Distribution(Contents contents);

 private:
  [[nodiscard]] double value_at(double cell) const;

  Ruler ruler_;
  std::int64_t count_ = 0, below_ = 0, above_ = 0;
  Sum sum_ = 0, squares_ = 0;
  std::vector<std::int64_t> counts_;
};

}  // namespace artcal
