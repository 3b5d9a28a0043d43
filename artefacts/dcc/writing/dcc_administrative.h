#pragma once

#include "artefacts/dcc/writing/dcc_document.h"

namespace pugi {
class xml_node;
}

namespace artcal {

/// Adds dcc:administrativeData: who, what, when, and first among the statements that these are unsigned data.
void add_administrative(pugi::xml_node& root, const DccDocument& document);

}  // namespace artcal
