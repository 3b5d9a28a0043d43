#include "app/report/over_time/change_table.h"

#include <cmath>

#include <fmt/format.h>

#include "app/report/numbers.h"
#include "app/results/shown_unit.h"

namespace artcal {
namespace {

void add(html::Table& table, const ParameterChange& change) {
  const ShownUnit as = shown_unit(change.name, change.unit);
  const double difference = change.now - change.then;
  table.add_markup({html::cell(change.name), as.name, fmt::format("{:.{}f}", change.then / as.size, as.decimals),
                    fmt::format("{:.{}f}", change.now / as.size, as.decimals),
                    fmt::format("{:+.{}f}", difference / as.size, as.decimals), numbers::two_digits(change.u / as.size),
                    fmt::format("{:.1f}", std::abs(difference) / change.u), change.significant ? "⚠ significant" : ""},
                   change.significant ? "notable" : "");
}

}  // namespace

html::Table change_table(const std::string& caption, const std::vector<ParameterChange>& changes) {
  html::Table table(caption, {{"parameter", false, true},
                              {"unit", false},
                              {"first"},
                              {"last"},
                              {"change", true, false, false, false, true},
                              {"u"},
                              {"change / u"},
                              {"", false, false, false, false, true}});
  for (const ParameterChange& change : changes) {
    add(table, change);
  }
  return table;
}

}  // namespace artcal
