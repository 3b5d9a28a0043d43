#pragma once

#include <optional>
#include <string>
#include <vector>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"

namespace artcal {

/// What a certified value cannot be, such as U = 0.9 mm of a bar or a reference temperature of 68 degC: a sentence for
/// each kind of value, with the unit that it looks like where one does. The ranges hold for artefacts that coordinate
/// measuring arms are calibrated with; what lies in them may still be wrong.
std::vector<std::string> implausible_values(const Artefact& artefact);

/// The same of the temperatures of the readings and of the radii of the tips.
std::vector<std::string> implausible_values(const Recording& recording);

/// " (20.4 degC in degrees Fahrenheit?)" where a number that is no temperature of a room in degC is one in another
/// unit; else empty.
std::string unit_of_temperature(double temperature);

/// Whether a laboratory can have that temperature: 0 to 50 degC.
bool is_room_temperature(double temperature);

/// "0.9 mm", "0.9 um": a length with the unit that shows it best; mm in.
std::string length_text(double length);

}  // namespace artcal
