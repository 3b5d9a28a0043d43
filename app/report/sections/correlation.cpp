#include "app/report/sections/correlation.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_told = 5;

struct Pair {
  std::size_t first = 0, second = 0;
  double correlation = 0.0;
};

std::vector<Pair> pairs_of(const Eigen::MatrixXd& matrix) {
  std::vector<Pair> pairs;
  const auto at = [&](std::size_t i, std::size_t j) {
    return matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(matrix.rows()); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      pairs.push_back({i, j, at(i, j) / std::sqrt(at(i, i) * at(j, j))});
    }
  }
  return pairs;
}

std::string closest_in_words(std::vector<Pair> pairs, const std::vector<std::string>& names) {
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return std::abs(a.correlation) > std::abs(b.correlation); });
  std::string text;
  for (std::size_t i = 0; i < std::min(most_told, pairs.size()); ++i) {
    text += fmt::format("{}{} with {} {:+.2f}", i == 0 ? "" : ", ", names[pairs[i].first], names[pairs[i].second],
                        pairs[i].correlation);
  }
  return text;
}

}  // namespace

Figure correlation_of(const RecordedCovariance& covariance) {
  const auto& names = covariance.parameters;
  const auto pairs = pairs_of(covariance.matrix);
  Json x = Json::array(), y = Json::array(), values = Json::array();
  for (const Pair& pair : pairs) {
    x.push_back(pair.second);
    y.push_back(pair.first);
    values.push_back(std::round(1000.0 * pair.correlation) / 1000.0);
  }
  return {"Correlations of the identified parameters",
          fmt::format("Closest: {}. The larger the mark, the closer the pair; full squares are positive, open circles "
                      "negative.",
                      closest_in_words(pairs, names)),
          {{"kind", "correlations"}, {"names", names}, {"x", x}, {"y", y}, {"values", values}},
          true};
}

}  // namespace artcal
