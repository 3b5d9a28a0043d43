#include "app/report/over_time/drift.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "app/report/numbers.h"
#include "app/report/over_time/dated_results.h"
#include "app/report/over_time/parameters_over_time.h"
#include "app/report/sections/test_values.h"
#include "app/results/verification/standard_name.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

const RecordedVerification& verification_in(const RecordedResult& result) {
  return std::get<RecordedVerification>(result.content);
}

void write_test_values(const DatedResults& results, const std::string& standard, Sheet& sheet) {
  const ResultTimes times = times_of(results);
  std::map<std::string, std::vector<std::optional<RecordedValue>>> worst;
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (const ValuesOfQuantity& quantity : by_quantity(verification_in(*results[i]).values)) {
      worst[quantity.quantity].resize(results.size());
      worst[quantity.quantity][i] = quantity.worst != nullptr ? std::optional(*quantity.worst) : std::nullopt;
    }
  }
  sheet.part(fmt::format("Values by {}", standard_in_words(standard)));
  Json series = Json::array();
  html::Table table(fmt::format("The worst of each quantity over time, µm: {}", worst_is),
                    {{"quantity", false, true},
                     {"when", false},
                     {"value"},
                     {"limit"},
                     {"u"},
                     {"verdict", false, false, false, false, true}});
  for (const auto& [quantity, values] : worst) {
    Json x = Json::array(), y = Json::array(), bars = Json::array();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!values[i]) {
        continue;
      }
      const RecordedValue& value = *values[i];
      const std::string when = times.labels[i];
      table.add({shown(quantity), when, value_in_words(value), value.limit ? micrometres(*value.limit) : "–",
                 micrometres(value.u), verdict_in_words(value)});
      x.push_back(when);
      y.push_back(drawn(std::abs(value.value) / units::micrometre));
      bars.push_back(drawn(2.0 * value.u / units::micrometre));
    }
    series.push_back({{"name", shown(quantity)}, {"x", x}, {"y", y}, {"bars", bars}});
  }
  sheet.figure(
      {"The worst of each quantity over time",
       fmt::format(
           "Of each verification {}. Sizes without sign; bars are twice the standard uncertainty of the test value.",
           worst_is),
       {{"kind", "drift"}, {"quantity", "worst"}, {"unit", "µm"}, {"dated", times.dated}, {"series", series}}});
  sheet.table(table);
}

}  // namespace

void write_drift(const std::vector<RecordedResult>& results, Sheet& sheet) {
  const DatedResults identifications = dated<RecordedIdentification>(results);
  std::map<std::string, DatedResults> by_standard;
  for (const RecordedResult* verification : dated<RecordedVerification>(results)) {
    by_standard[verification_in(*verification).standard].push_back(verification);
  }
  std::erase_if(by_standard, [](const auto& entry) { return entry.second.size() < 2; });
  if (identifications.size() < 2 && by_standard.empty()) {
    return;
  }
  sheet.section("Over time");
  if (identifications.size() > 1) {
    write_parameters_over_time(identifications, sheet);
  }
  for (const auto& [standard, verifications] : by_standard) {
    write_test_values(verifications, standard, sheet);
  }
}

}  // namespace artcal
