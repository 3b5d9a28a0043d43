#pragma once

#include <string>

#include "acquisition/recording/recording.h"
#include "identification/identifiability/coupling.h"

namespace artcal {

/// What readings cannot determine, and what they tell poorly; nothing where they tell all well.
std::string cannot_text(const Coupling& coupling);

/// What readings can tell, and what not.
std::string to_text(const Recording& recording, const Coupling& coupling);

}  // namespace artcal
