#pragma once

#include <string>
#include <string_view>

#include "artefacts/dcc/dcc.h"
#include "core/error.h"

namespace artcal {

/// The one quantity that `key` names: by id, else by name, else by reference type; or by "part/…/name", where parts are
/// ids, names or reference types of what it is in. White space within names does not matter. None or several: a refusal
/// that lists what there is. One with a fault: its fault.
Expected<DccQuantity> find_quantity(const DccCertificate& certificate, std::string_view key);

/// All quantities of a certificate in a line, for people; the first dozen if there are more.
std::string list_of_quantities(const DccCertificate& certificate);

}  // namespace artcal
