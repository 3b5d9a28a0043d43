#include "artefacts/verification/budget.h"

#include <cmath>

namespace artcal {

double Budget::total() const {
  return std::sqrt(calibration * calibration + expansion * expansion + temperature * temperature +
                   alignment * alignment + fixture * fixture + form * form);
}

Budget with_thermal(Budget budget, double length, const ThermalState& state) {
  budget.expansion = length * std::abs(state.difference) * state.u_expansion;
  budget.temperature = length * std::abs(state.expansion) * state.u_temperature;
  return budget;
}

double form_uncertainty(double form, double u_form) { return std::hypot(0.5 * form, u_form); }

}  // namespace artcal
