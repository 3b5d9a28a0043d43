#pragma once

#include <optional>
#include <string>

#include "artefacts/artefact/artefact.h"

namespace artcal {

/// What an artefact says that cannot be true, and where it says so.
struct Contradiction {
  enum class Of { Feature, Distance, Ends };
  Of of = Of::Feature;
  int index = 0;  ///< into Artefact::features, or into Artefact::distances
  std::string message;
};

/// The first contradiction within an artefact, if there is one: features that its type does not have, two features
/// in one place, balls that overlap, a distance stated twice, or further from the certified coordinates than its U,
/// or longer than a way round over other distances. Uncertainties count with k = 2, and with
/// more where many distances are compared; those of coordinates and
/// of the distances of a way are taken as independent.
std::optional<Contradiction> find_contradiction(const Artefact& artefact);

}  // namespace artcal
