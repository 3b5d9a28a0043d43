#include "app/results/unit_check.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/units.h"

namespace artcal {

std::optional<std::string_view> likelier_unit(double measured, double expected, double unit_factor) {
  using Unit = std::pair<std::string_view, double>;
  // Centimetres and feet are what a wrong export may have, though no file of artcal's may.
  constexpr std::array<Unit, 6> candidates{{{"mm", units::millimetre},
                                            {"um", units::micrometre},
                                            {"m", units::metre},
                                            {"in", units::inch},
                                            {"cm", 10.0},
                                            {"ft", 12.0 * units::inch}}};
  for (const auto& [name, factor] : candidates) {
    if (factor != unit_factor && std::abs(measured * factor / unit_factor / expected - 1.0) < 0.2) {
      return name;
    }
  }
  return std::nullopt;
}

}  // namespace artcal
