#pragma once

#include <optional>

#include "artefacts/dcc/dcc.h"
#include "core/xml/xml.h"

namespace artcal {

/// What an element of a DCC is called.
DccLabels dcc_labels(const pugi::xml_node& node);

/// Reads a dcc:quantity: si:real, si:constant, si:realListXMLList, si:realList, si:list of si:real, or several of one
/// of them in si:hybrid; and dcc:relativeUncertainty where none of them states an uncertainty itself. What is not read
/// becomes the quantity's fault. Nothing where the quantity holds a text.
std::optional<DccQuantity> read_quantity(const XmlSource& source, const pugi::xml_node& node);

}  // namespace artcal
