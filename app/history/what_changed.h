#pragma once

#include <string>
#include <vector>

#include "app/history/arm_history.h"

namespace artcal {

/// What changed most, in one sentence, and whether that is more than chance.
struct ChangeSentence {
  std::string text;
  bool significant = false;
};

/// What a history says first: of the parameters, then of each standard, what changed, by how much in measured lengths
/// and on which day it was seen first. `micrometre` is the sign of the unit: terminals get "um".
std::vector<ChangeSentence> what_changed(const ArmHistory& history, const char* micrometre);

/// "2026-03-09"; of a recording without a date its name.
std::string day_of(const HistoryEntry& entry);

/// "lengths by up to 90.3 µm, 25.1 µm rms"; empty where the arms are not known.
std::string lengths_in_words(const CalibrationStep& step, const char* micrometre);

/// The change of largest size among those of the step that are significant, else among all; null where there is none.
/// Lengths before what is no length: diameters and forms.
const Drift* largest_drift(const VerificationStep& step);

}  // namespace artcal
