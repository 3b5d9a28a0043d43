#include "app/results/shown_unit.h"

#include <fmt/format.h>

#include "core/units.h"

namespace artcal {

ShownUnit shown_unit(std::string_view name, std::string_view unit) {
  if (unit == "rad/rad") {
    return {"ppm", 1e-6, 3};
  }
  if (unit == "rad/(N mm)") {
    return {"arcsec/(N m)", 1e-3 * units::arcsecond, 4};
  }
  if (unit == "1/K") {
    return {"ppm/K", 1e-6, 3};
  }
  if (unit != "rad") {
    return {"mm", 1.0, 5};
  }
  const bool harmonic = name.starts_with("cos_") || name.starts_with("sin_");
  return harmonic ? ShownUnit{"arcsec", units::arcsecond, 3} : ShownUnit{"deg", units::degree, 6};
}

std::string in_micrometres(double mm) { return fmt::format("{:.1f}", mm / units::micrometre); }
std::string signed_in_micrometres(double mm) { return fmt::format("{:+.1f}", mm / units::micrometre); }

}  // namespace artcal
