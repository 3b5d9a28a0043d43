#pragma once

#include <string_view>

namespace artcal {

/// How an arm is brought near enough to its readings for the fit to the spheres.
enum class Alignment {
  None,           ///< the fit begins at the nominal arm
  StylusCentres,  ///< each centre of a ball is taken to lie beyond the tip, along the stylus, by both radii
  TipCentres,     ///< each centre of a ball is taken to be the tip's
  Robust,         ///< the fit to the spheres with a loss that narrows, so that balls on the wrong side do not count
  JointsFirst,    ///< as StylusCentres, the joints' zero offsets before all other parameters
};
std::string_view name_of(Alignment alignment);

}  // namespace artcal
