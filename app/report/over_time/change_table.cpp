#include "app/report/over_time/change_table.h"

#include <cmath>

#include <fmt/format.h>

#include "app/report/numbers.h"
#include "app/results/shown_unit.h"

namespace artcal {
namespace {

ShownChange shown_change(const ParameterChange& change) {
  const ShownUnit as = shown_unit(change.name, change.unit);
  const double difference = change.now - change.then;
  return {html::cell(change.name),
          as.name,
          fmt::format("{:.{}f}", change.then / as.size, as.decimals),
          fmt::format("{:.{}f}", change.now / as.size, as.decimals),
          fmt::format("{:+.{}f}", difference / as.size, as.decimals),
          change.u / as.size,
          std::abs(difference) / change.u,
          change.significant};
}

}  // namespace

html::Table change_table(const std::string& caption, const std::string& what, const std::string& beside,
                         const std::vector<ShownChange>& changes) {
  html::Table table(caption, {{what, false, true},
                              {beside, false},
                              {"first"},
                              {"last"},
                              {"change", true, false, false, false, true},
                              {"u"},
                              {"change / u"},
                              {"", false, false, false, false, true}});
  for (const ShownChange& change : changes) {
    table.add_markup({change.what, change.beside, change.then, change.now, change.change, numbers::two_digits(change.u),
                      fmt::format("{:.1f}", change.times_u), change.significant ? "⚠ significant" : change.remark},
                     change.significant ? "notable" : "");
  }
  return table;
}

html::Table change_table(const std::string& caption, const std::vector<ParameterChange>& changes) {
  std::vector<ShownChange> shown;
  for (const ParameterChange& change : changes) {
    shown.push_back(shown_change(change));
  }
  return change_table(caption, "parameter", "unit", shown);
}

}  // namespace artcal
