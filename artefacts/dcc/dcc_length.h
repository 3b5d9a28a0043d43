#pragma once

#include "artefacts/dcc/dcc.h"

namespace artcal {

/// The factor from a D-SI unit of length to mm; nothing where it is not one that is known here.
std::optional<double> dsi_length_unit(std::string_view unit);

/// Lengths of a certificate, in mm.
struct DccLengths {
  std::vector<double> values;
  std::vector<DccUncertainty> uncertainties;  ///< one a value; none where none is stated or none is read
  std::string unread_uncertainty;             ///< what states an uncertainty that is not read; else empty
  std::vector<std::string> labels;            ///< of each value; none where they have none
};

/// A quantity's numbers as lengths. Of several representations in units of length (si:hybrid) the one with the most
/// digits counts, the first of equals; its uncertainty may stand in another one.
///
/// Refused, in a sentence that names the quantity: no representation in a unit of length; NaN; an uncertainty or a
/// coverage factor that is not above zero; representations that contradict each other by more than rounding, in their
/// values or, by more than half, in their uncertainties.
Expected<DccLengths> lengths_of(const DccQuantity& quantity);

}  // namespace artcal
