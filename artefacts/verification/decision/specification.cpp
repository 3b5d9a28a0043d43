#include "artefacts/verification/decision/specification.h"

#include "core/enum_names.h"

namespace artcal {
namespace {

constexpr EnumNames<Quantity, 11> words_of_quantities{{{Quantity::SizeError, "P_Size"},
                                                       {Quantity::FormError, "P_Form"},
                                                       {Quantity::SizeErrorAll, "P_Size.Sph.All"},
                                                       {Quantity::FormErrorD95, "P_Form.Sph.D95%"},
                                                       {Quantity::LocationDiameter, "L_Dia"},
                                                       {Quantity::LengthUni, "E_Uni"},
                                                       {Quantity::LengthBi, "E_Bi"},
                                                       {Quantity::EffectiveDiameter, "effective_diameter"},
                                                       {Quantity::Articulation, "SPAT"},
                                                       {Quantity::ArticulationSpread, "SPAT_2s"},
                                                       {Quantity::Volumetric, "volumetric"}}};

}  // namespace

const char* name_of(Quantity quantity) { return name_in(words_of_quantities, quantity); }

bool is_signed(Quantity quantity) {
  switch (quantity) {
    case Quantity::FormError:
    case Quantity::FormErrorD95:
    case Quantity::LocationDiameter:
    case Quantity::Articulation:
    case Quantity::ArticulationSpread: return false;
    case Quantity::SizeError:
    case Quantity::SizeErrorAll:
    case Quantity::LengthUni:
    case Quantity::LengthBi:
    case Quantity::EffectiveDiameter:
    case Quantity::Volumetric: break;
  }
  return true;
}

std::string quantity_names() { return list_of(words_of_quantities); }

std::optional<Quantity> quantity_named(const std::string& name) { return value_in(words_of_quantities, name); }

}  // namespace artcal
