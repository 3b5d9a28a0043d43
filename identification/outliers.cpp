#include "identification/outliers.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"

namespace artcal {

std::vector<Outlier> find_outliers(const Recording& recording, const Constraints& constraints,
                                   const WhitenedResiduals& residuals, const Evaluation& evaluation) {
  const auto count = static_cast<double>(evaluation.deviations.size());
  const double limit[] = {0.0, std::sqrt(chi_squared_quantile(1.0 - 0.05 / count, 1.0)), 0.0,
                          std::sqrt(chi_squared_quantile(1.0 - 0.05 / count, 3.0))};
  std::vector<Outlier> outliers;
  std::size_t flat = 0;
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    const int dimension = feature.dimension();
    for (int k = 0; k < feature.size(); ++k, ++flat) {
      const double size = Eigen::VectorXd::Map(residuals.readings[f].data() + k * dimension, dimension).norm();
      if (size > limit[dimension]) {
        outliers.push_back({feature.readings[k], name_of(feature, constraints, recording), size, limit[dimension],
                            evaluation.deviations[flat]});
      }
    }
  }
  std::stable_sort(outliers.begin(), outliers.end(), [](const Outlier& a, const Outlier& b) {
    return a.standardised / a.limit > b.standardised / b.limit;
  });
  return outliers;
}

}  // namespace artcal
