#include "artefacts/verification/specification.h"

#include <array>

namespace artcal {
namespace {

constexpr std::array<std::pair<Quantity, const char*>, 9> names{{{Quantity::SizeError, "P_Size"},
                                                                 {Quantity::FormError, "P_Form"},
                                                                 {Quantity::LocationDiameter, "L_Dia"},
                                                                 {Quantity::LengthUni, "E_Uni"},
                                                                 {Quantity::LengthBi, "E_Bi"},
                                                                 {Quantity::EffectiveDiameter, "effective_diameter"},
                                                                 {Quantity::Articulation, "SPAT"},
                                                                 {Quantity::ArticulationSpread, "SPAT_2s"},
                                                                 {Quantity::Volumetric, "volumetric"}}};

}  // namespace

const char* name_of(Quantity quantity) {
  for (const auto& [known, name] : names) {
    if (known == quantity) {
      return name;
    }
  }
  return "";
}

std::optional<Quantity> quantity_named(const std::string& name) {
  for (const auto& [quantity, known] : names) {
    if (name == known) {
      return quantity;
    }
  }
  return std::nullopt;
}

}  // namespace artcal
