#include "identification/identifiability/observability.h"

#include <cmath>

namespace artcal {

Observability observability_of(const Eigen::VectorXd& singular_values, int readings) {
  const auto sigma = singular_values.array();
  const double first = sigma[0];
  const double last = sigma[sigma.size() - 1];
  if (last <= 0.0) {
    return {};
  }
  return {std::exp(sigma.log().mean()) / std::sqrt(readings), last / first, last, last * last / first,
          1.0 / sigma.inverse().sum()};
}

}  // namespace artcal
