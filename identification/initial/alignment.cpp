#include "identification/initial/alignment.h"

namespace artcal {

std::string_view name_of(Alignment alignment) {
  switch (alignment) {
    case Alignment::None: return "none";
    case Alignment::StylusCentres: return "centres along the stylus";
    case Alignment::TipCentres: return "centres at the tip";
    case Alignment::Robust: return "robust";
    case Alignment::JointsFirst: return "zero offsets first";
  }
  return "";
}

}  // namespace artcal
