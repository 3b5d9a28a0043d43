#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "artefacts/artefact/artefact.h"

namespace artcal {

/// The type that a file calls "ball bar", "sphere plate", "plane", "sphere", "seat plate", "step gauge",
/// "gauge block" or "telescoping bar"; nothing for other names.
std::optional<ArtefactType> artefact_type(std::string_view name);

/// All of these names, for a message.
std::string artefact_type_names();

/// That name; "artefact" for ArtefactType::Other.
std::string_view name_of(ArtefactType type);

/// A feature that an artefact of its type does not have, or too few or too many of them.
struct TypeContradiction {
  int feature = 0;
  std::string message;
};
std::optional<TypeContradiction> contradiction_of_type(const Artefact& artefact);

}  // namespace artcal
