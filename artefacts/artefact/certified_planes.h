#pragma once

#include "artefacts/artefact/artefact.h"
#include "core/error.h"

namespace artcal {

/// Bad input: a plane with a certified place and no normal, a distance between a plane and something else or between
/// planes that are not parallel.
Expected<void> check_planes(const Artefact& artefact);

}  // namespace artcal
