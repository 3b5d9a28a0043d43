#include "app/report/sections/lengths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>

#include "app/report/numbers.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

// A length by its artefact, its placement and its two ends.
using LengthKey = std::array<std::string, 4>;
LengthKey key_of(const Json& length) {
  return {text_in(length, "artefact"), text_in(length, "placement"), text_in(length, "first"),
          text_in(length, "second")};
}

// Lengths by an arm identified without their placement.
std::map<LengthKey, const Json*> left_out_lengths(const Json& left_out) {
  std::map<LengthKey, const Json*> lengths;
  for (const Json& left : left_out) {
    for (const Json& length : left.at("lengths")) {
      lengths.emplace(key_of(length), &length);
    }
  }
  return lengths;
}

// Results of earlier versions have the length at the temperature of the placement alone, as `certified_mm`.
double at_temperature(const Json& length) {
  return length.contains("at_temperature_mm") ? length.at("at_temperature_mm") : length.at("certified_mm");
}
std::string certified(const Json& length) {
  return length.contains("certified_at_C") ? mm(length.at("certified_mm")) : "–";
}
std::string certified_at(const Json& length) {
  return length.contains("certified_at_C") ? fmt::format("{:.4g}", length.at("certified_at_C").get<double>()) : "–";
}

Figure figure_of(const Json& after, const std::vector<const Json*>& left_out) {
  double largest = 0.0;
  for (const Json& length : after) {
    largest = std::max(largest, std::abs(length.at("error_mm").get<double>()));
  }
  for (const Json* left : left_out) {
    largest = std::max(largest, left == nullptr ? 0.0 : std::abs(left->at("error_mm").get<double>()));
  }
  const bool any_left_out =
      std::any_of(left_out.begin(), left_out.end(), [](const Json* left) { return left != nullptr; });
  const DrawnUnit unit = drawn_unit(largest);
  Json x = Json::array(), fitted = Json::array(), unseen = Json::array(), names = Json::array();
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Json& length = after[i];
    x.push_back(at_temperature(length));
    fitted.push_back(drawn(unit.per_mm * length.at("error_mm").get<double>()));
    unseen.push_back(left_out[i] == nullptr ? Json(nullptr)
                                            : drawn(unit.per_mm * left_out[i]->at("error_mm").get<double>()));
    names.push_back(shown(
        fmt::format("{}: {} – {}", text_in(length, "placement"), text_in(length, "first"), text_in(length, "second"))));
  }
  return {"Errors of the certified lengths over length",
          fmt::format("Measured less certified; the largest is {} mm.{}", mm(largest),
                      any_left_out ? " Full circles: the identified arm; open squares: an arm identified without the "
                                     "placement."
                                   : ""),
          {{"kind", "lengths"},
           {"unit", unit.name},
           {"names", names},
           {"series",
            {{{"name", "identified arm"}, {"symbol", "circle"}, {"x", x}, {"y", fitted}},
             {{"name", "cross-validation"}, {"symbol", "square-open"}, {"x", x}, {"y", unseen}}}}}};
}

}  // namespace

void write_length_errors(const Json& identification, Sheet& sheet) {
  const Json& before = identification.at("before").at("lengths");
  const Json& after = identification.at("after").at("lengths");
  html::Table table("Certified lengths as the arm measures them, errors in mm",
                    {{"placement", false, true},
                     {"between", false},
                     {"certified"},
                     {"at, °C"},
                     {"at temperature"},
                     {"before"},
                     {"after"},
                     {"cross-val.", true, false, false, true}});
  const auto without_placement = left_out_lengths(identification.at("left_out"));
  std::vector<const Json*> left_out;  // null where there is none
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Json& length = after[i];
    const auto left = without_placement.find(key_of(length));
    left_out.push_back(left == without_placement.end() ? nullptr : left->second);
    table.add({shown(text_in(length, "placement")),
               shown(text_in(length, "first")) + " – " + shown(text_in(length, "second")), certified(length),
               certified_at(length), mm(at_temperature(length)), signed_mm(number_in(before.at(i).at("error_mm"))),
               signed_mm(length.at("error_mm")),
               left_out.back() == nullptr ? "–" : signed_mm(left_out.back()->at("error_mm"))});
  }
  sheet.part("Certified lengths");
  sheet.figure(figure_of(after, left_out));
  sheet.table(table);
}

}  // namespace artcal
