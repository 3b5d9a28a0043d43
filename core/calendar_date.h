#pragma once

#include <string_view>

namespace artcal {

/// Whether a text is a day of the (Gregorian) calendar as ISO 8601 writes it: "2026-03-02", years 1900 to
/// 9999. Two such texts compare as the days do.
bool is_calendar_date(std::string_view text);

}  // namespace artcal
