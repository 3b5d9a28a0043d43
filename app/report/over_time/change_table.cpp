#include "app/report/over_time/change_table.h"

#include <cmath>

#include <fmt/format.h>

#include "app/report/numbers.h"
#include "app/results/shown_unit.h"

namespace artcal {

html::Table change_table(const std::string& caption) {
  return {caption,
          {{"parameter", false, true},
           {"unit", false},
           {"first"},
           {"last"},
           {"change", true, false, false, false, true},
           {"u"},
           {"change / u"},
           {"", false, false, false, false, true}}};
}

void add(html::Table& table, const ChangeRow& change) {
  const ShownUnit as = shown_unit(change.name, change.unit);
  const double difference = change.now - change.then;
  table.add_markup({html::cell(change.name), as.name, fmt::format("{:.{}f}", change.then / as.size, as.decimals),
                    fmt::format("{:.{}f}", change.now / as.size, as.decimals),
                    fmt::format("{:+.{}f}", difference / as.size, as.decimals), numbers::two_digits(change.u / as.size),
                    fmt::format("{:.1f}", std::abs(difference) / change.u), change.remark},
                   change.remark.empty() ? "" : "notable");
}

}  // namespace artcal
