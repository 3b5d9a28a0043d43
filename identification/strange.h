#pragma once

#include <optional>
#include <string>

#include "identification/evaluation.h"

namespace artcal {

/// What fits an arm far worse than the rest does, in words; nothing where nothing stands out by `far_off` (mm) and five
/// times what is usual. A feature (by the rms of its readings): the wrong ball was read, or in another place than the
/// rest, or some of its readings are another feature's. Else a certified distance: features have each other's names.
std::optional<std::string> what_stands_out(const Evaluation& evaluation, double far_off);

}  // namespace artcal
