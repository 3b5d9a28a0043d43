#include "artefacts/verification/decision/budget.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/statistics.h"

namespace artcal {

double Budget::total() const {
  return std::sqrt(calibration * calibration + expansion * expansion + temperature * temperature +
                   alignment * alignment + fixture * fixture + form * form + points * points);
}

double Budget::degrees_of_freedom() const {
  const std::array parts{UncertaintyComponent{points, points_freedom},
                         UncertaintyComponent{std::sqrt(std::max(0.0, total() * total() - points * points))}};
  return effective_degrees_of_freedom(parts);
}

Budget with_thermal(Budget budget, double length, const ThermalState& state) {
  budget.expansion = length * std::abs(state.difference) * state.u_expansion;
  budget.temperature = length * std::abs(state.expansion) * state.u_temperature;
  return budget;
}

double form_uncertainty(double form, double u_form) { return std::hypot(0.5 * form, u_form); }

}  // namespace artcal
