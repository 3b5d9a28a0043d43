#include "artefacts/verification/specification.h"

#include <array>

namespace artcal {
namespace {

constexpr std::array<std::pair<Quantity, const char*>, 11> names{{{Quantity::SizeError, "P_Size"},
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

const char* name_of(Quantity quantity) {
  for (const auto& [known, name] : names) {
    if (known == quantity) {
      return name;
    }
  }
  return "";
}

std::string quantity_names() {
  std::string text;
  for (const auto& [quantity, name] : names) {
    text += (text.empty() ? "" : quantity == names.back().first ? " or " : ", ") + std::string(name);
  }
  return text;
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
