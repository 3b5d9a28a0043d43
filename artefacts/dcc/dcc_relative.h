#pragma once

#include "artefacts/dcc/dcc.h"
#include "core/xml/xml.h"

namespace artcal {

/// Reads dcc:relativeUncertainty of a quantity and gives every representation of it U = U_rel·|value|. Nothing is
/// changed where there is none, or where a representation states an uncertainty of its own: the absolute one counts.
/// Its coverage factor is that which stands in it; without one k is 0 (PTB asks for the absolute uncertainty, with k,
/// beside it: wiki.dcc.ptb.de, "dcc:relativeUncertainty"). Refused: numbers that are none, or that do not fit the
/// values.
Expected<void> add_relative_uncertainty(const XmlSource& source, const pugi::xml_node& quantity,
                                        std::vector<DccNumbers>& representations);

/// The factor of a D-SI unit of a ratio, such as "\\one", "\\percent" or "\\micro\\metre\\per\\metre"; nothing where it
/// is not one that is known here.
std::optional<double> dsi_ratio_unit(std::string_view unit);

}  // namespace artcal
