#pragma once

#include "artefacts/dcc/dcc.h"
#include "core/xml/xml.h"

namespace artcal {

/// Reads si:real, si:constant, si:realListXMLList, si:realList or a si:list of these, with their units and
/// uncertainties. Refused: complex numbers, a number that is none, another number of units than one for all or one
/// each, an uncertainty that does not fit its numbers.
Expected<DccNumbers> read_dcc_numbers(const XmlSource& source, const pugi::xml_node& node);

/// The same of an element that has the content of si:realListXMLList (`is_list`) or of si:real under another name.
Expected<DccNumbers> read_dcc_numbers_as(const XmlSource& source, const pugi::xml_node& node, bool is_list);

}  // namespace artcal
