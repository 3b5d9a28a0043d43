#pragma once

#include <string>

#include "artefacts/dcc/writing/dcc_document.h"

namespace artcal {

/// The document as XML: DCC 3.3.0 with D-SI 2.2.1, UTF-8. It says of itself, first among its statements, that it is
/// unsigned data and no certificate until a laboratory makes it one. Control characters become spaces, everything else
/// is escaped. REQUIRES: the texts that may not be empty are not, there is a result, and each has an entry.
std::string dcc_xml(const DccDocument& document);

}  // namespace artcal
