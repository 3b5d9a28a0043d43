#include "core/calendar_date.h"

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(CalendarDate, IsADayThatTheCalendarHas) {
  for (const char* day : {"2026-03-02", "2024-02-29", "2000-02-29", "1900-01-01", "9999-12-31"}) {
    EXPECT_TRUE(is_calendar_date(day)) << day;
  }
  for (const char* none :
       {"2026-02-31", "2026-02-29", "2100-02-29", "2026-04-31", "2026-00-10", "2026-01-00", "1899-12-31", "2026-3-02",
        "2026-03-2", "2026/03/02", "2026-03-02 ", " 2026-03-02", "+026-03-02", "20260302", "", "2026-03-0x"}) {
    EXPECT_FALSE(is_calendar_date(none)) << none;
  }
}

}  // namespace
}  // namespace artcal
