#pragma once

#include <optional>

#include "artefacts/dcc.h"
#include "core/text_file.h"

namespace pugi {
class xml_node;
}

namespace artcal {

/// What an element of a DCC is called.
DccLabels dcc_labels(const pugi::xml_node& node);

/// Reads the number or list of numbers of a dcc:quantity. Nothing where it holds none. Both generations of D-SI
/// uncertainties: expandedUnc, coverageInterval; measurementUncertaintyUnivariate with standardMU, expandedMU,
/// coverageIntervalMU; and their lists.
Expected<std::optional<DccQuantity>> read_quantity(const TextFile& file, const pugi::xml_node& node);

}  // namespace artcal
