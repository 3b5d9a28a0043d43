#pragma once

#include <string>
#include <string_view>

namespace artcal {

/// In what unit a person reads a parameter of an arm, and with how many decimals.
struct ShownUnit {
  const char* name;  ///< "deg", "mm", "arcsec", "ppm", "arcsec/(N m)", "ppm/K"
  double size;       ///< in Parameter::unit()
  int decimals;
};

/// By the parameter's name and unit, as results write them.
ShownUnit shown_unit(std::string_view name, std::string_view unit);

/// A length in mm as micrometres with one decimal, 204.8, and with its sign.
std::string in_micrometres(double mm);
std::string signed_in_micrometres(double mm);

}  // namespace artcal
