#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace artcal {

/// The unit, other than the one a length was read in, in which it would have come out as it should; nothing
/// where no unit makes it fit within a fifth. `measured` was read with `unit_factor` mm per unit.
std::optional<std::string_view> likelier_unit(double measured, double expected, double unit_factor);

}  // namespace artcal
