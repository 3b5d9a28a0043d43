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

std::string quantity_names() { return list_of(words_of_quantities); }

std::optional<Quantity> quantity_named(const std::string& name) { return value_in(words_of_quantities, name); }

}  // namespace artcal
