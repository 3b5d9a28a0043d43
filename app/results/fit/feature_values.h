#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/fit.h"

namespace artcal {

/// One number of a fitted feature, as results name it.
struct FeatureValue {
  std::string name;  ///< such as "centre x"
  std::string unit;  ///< mm, rad, or "1" for a component of a unit vector
  double value = 0.0;
  std::optional<double> u;  ///< standard uncertainty; none where the fit has no covariance
};

/// F::parameters() by their names, in their order.
template <typename F>
std::vector<std::string> parameter_names();

/// What a person asks of a feature: diameters instead of radii, a cone's apex and full angle too.
template <typename F>
std::vector<FeatureValue> feature_values(const Fitted<F>& fitted);

}  // namespace artcal
