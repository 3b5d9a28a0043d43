#include "artefacts/verification/point_scatter.h"

#include <cmath>
#include <vector>

#include "core/statistics.h"

namespace artcal {

void PointScatter::add(double more_squares, int more_freedom) {
  squares += more_squares;
  degrees_of_freedom += more_freedom;
}

std::optional<double> PointScatter::deviation() const {
  return degrees_of_freedom > 0 ? std::optional(std::sqrt(squares / degrees_of_freedom)) : std::nullopt;
}

void Dilution::add(PointKind kind, double contribution, double largest, const std::string& feature) {
  double& sum = of_value[static_cast<std::size_t>(kind)];
  sum = std::hypot(sum, contribution);
  if (largest > worst) {
    worst = largest;
    worst_feature = feature;
  }
}

PointUncertainty point_uncertainty(const Dilution& dilution, const PointScatters& scatters,
                                   const std::optional<double>& otherwise) {
  PointUncertainty result;
  std::vector<UncertaintyComponent> components;
  for (std::size_t kind = 0; kind < point_kinds; ++kind) {
    if (dilution.of_value[kind] == 0.0) {
      continue;
    }
    if (const auto s = scatters[kind].deviation()) {
      components.push_back({*s * dilution.of_value[kind], static_cast<double>(scatters[kind].degrees_of_freedom)});
    } else if (otherwise) {
      components.push_back({*otherwise * dilution.of_value[kind]});
    } else {
      result.is_known = false;
    }
  }
  for (const UncertaintyComponent& component : components) {
    result.u = std::hypot(result.u, component.u);
  }
  result.degrees_of_freedom = effective_degrees_of_freedom(components);
  return result;
}

}  // namespace artcal
