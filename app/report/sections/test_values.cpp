#include "app/report/sections/test_values.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "app/report/thinning.h"
#include "app/results/verification/standard_name.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

constexpr std::size_t max_rows = 330;   // of a quantity: the 300 lengths of a plate of 25 balls are all shown
constexpr int max_values_drawn = 1500;  // of a quantity

bool is_length(const Json& value) { return !value.at("second").is_null(); }

// How near to its limit; where there is none, how large.
double severity(const Json& value) {
  const double size = std::abs(value.at("value_mm").get<double>());
  return value.at("limit_mm").is_null() ? size : size / value.at("limit_mm").get<double>();
}

std::string limit_in_words(const Json& value) {
  return value.at("limit_mm").is_null() ? "–" : micrometres(value.at("limit_mm"));
}

std::string features_of(const Json& value) {
  const std::string first = shown(text_in(value, "first"));
  return is_length(value) ? first + " – " + shown(text_in(value, "second")) : first;
}

std::string place_in_words(const Json& place) {
  const double share = place.at("share_of_reach");
  std::string text = fmt::format("{}", place.at("octant").get<int>());
  text += share > 0.0 ? fmt::format(", {:.0f} %", 100.0 * share) : "";
  text += place.at("above_base").get<bool>() ? ", above the base" : "";
  text += place.at("joint_at_stop").is_null()
              ? ""
              : fmt::format(", joint {} at its stop", place.at("joint_at_stop").get<int>());
  return text;
}

std::string or_dash(const std::string& text) { return text.empty() ? "–" : text; }

std::string u_in_words(const Json& value) { return fmt::format("{:.2f}", 1000.0 * value.at("u_mm").get<double>()); }

// The largest error need not be the worst value: limits grow with the length.
std::string where_limits_differ(const std::vector<const ValuesOfQuantity*>& lengths) {
  std::string text;
  for (const ValuesOfQuantity* quantity : lengths) {
    if (quantity->worst != nullptr && !quantity->worst->at("limit_mm").is_null()) {
      text += fmt::format("; the largest share of its limit, {}, has {} with {} µm", share_in_words(*quantity->worst),
                          shown(quantity->quantity), value_in_words(*quantity->worst));
    }
  }
  return text;
}

// Results of earlier versions, and diameters, have the value at the reference temperature alone.
double stated(const Json& value) {
  const double stated = value.contains("stated_mm") ? number_in(value.at("stated_mm")) : NAN;
  return std::isfinite(stated) ? stated : number_in(value.at("certified_mm"));
}
std::string stated_at(const Json& value) {
  const double temperature = value.contains("stated_at_C") ? number_in(value.at("stated_at_C")) : NAN;
  return std::isfinite(temperature) ? fmt::format("{:.4g}", temperature) : "–";
}

// All in their order, or the most severe first.
std::vector<const Json*> rows_of(const ValuesOfQuantity& quantity) {
  std::vector<const Json*> rows = quantity.values;
  if (rows.size() <= max_rows) {
    return rows;
  }
  const auto fails = [](const Json* value) { return value->at("verdict") == "does_not_conform"; };
  std::stable_sort(rows.begin(), rows.end(), [&](const Json* a, const Json* b) {
    return std::pair(!fails(a), -severity(*a)) < std::pair(!fails(b), -severity(*b));
  });
  rows.resize(std::max(max_rows, static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), fails))));
  return rows;
}

/// The lengths of one quantity as a picture takes them.
struct DrawnLengths {
  Json series, band;
  std::size_t drawn_count = 0;
};

DrawnLengths drawn_lengths(const ValuesOfQuantity& quantity, const DrawnUnit& unit, const char* symbol) {
  std::vector<double> lengths, errors;
  std::map<double, double> limits;
  for (const Json* value : quantity.values) {
    lengths.push_back(number_in(value->at("certified_mm")));
    errors.push_back(value->at("value_mm"));
    if (!value->at("limit_mm").is_null()) {
      limits[lengths.back()] = value->at("limit_mm");
    }
  }
  Json x = Json::array(), y = Json::array(), names = Json::array(), verdicts = Json::array();
  const auto kept = thinned(lengths, errors, max_values_drawn);
  for (const int i : kept) {
    const Json& value = *quantity.values[i];
    x.push_back(drawn(lengths[i]));
    y.push_back(drawn(unit.per_mm * errors[i]));
    verdicts.push_back(value.at("verdict"));
    names.push_back(shown(text_in(value, "placement")) + ": " + features_of(value) + ", " + verdict_in_words(value));
  }
  Json band_x = Json::array(), band_y = Json::array();
  for (const auto& [length, limit] : limits) {
    band_x.push_back(drawn(length));
    band_y.push_back(drawn(unit.per_mm * limit));
  }
  return {
      {{"name", quantity.quantity}, {"symbol", symbol}, {"x", x}, {"y", y}, {"names", names}, {"verdicts", verdicts}},
      {{"name", "limit of " + quantity.quantity}, {"x", band_x}, {"y", band_y}},
      kept.size()};
}

}  // namespace

std::vector<ValuesOfQuantity> by_quantity(const Json& values) {
  std::vector<ValuesOfQuantity> quantities;
  std::map<std::string, std::size_t> places;
  for (const Json& value : values) {
    const std::string name = value.at("quantity");
    const auto [place, is_new] = places.try_emplace(name, quantities.size());
    if (is_new) {
      quantities.push_back({name, {}, nullptr});
    }
    ValuesOfQuantity& of_quantity = quantities[place->second];
    of_quantity.values.push_back(&value);
    const bool counts = !value.at("set_aside").get<bool>();
    if (counts && (of_quantity.worst == nullptr || severity(value) > severity(*of_quantity.worst))) {
      of_quantity.worst = &value;
    }
  }
  return quantities;
}

std::string verdict_in_words(const Json& value) {
  const std::string verdict = value.at("verdict");
  return value.at("set_aside").get<bool>() ? "set aside"
         : verdict == "conforms"           ? "✓\u00a0conformity proven"
         : verdict == "does_not_conform"   ? "✗\u00a0non\u2011conformity proven"
         : verdict == "nothing_proven"     ? "? neither proven"
                                           : "not judged";
}

std::string value_in_words(const Json& value) {
  const double mm = value.at("value_mm");
  return value.at("certified_mm").is_null() ? micrometres(mm) : signed_micrometres(mm);
}

std::string share_in_words(const Json& value) {
  return value.at("limit_mm").is_null() ? "–" : fmt::format("{:.0f} %", 100.0 * severity(value));
}

void write_worst_values(const std::vector<ValuesOfQuantity>& quantities, Sheet& sheet) {
  html::Table table(
      fmt::format("The worst of each quantity, µm: {}; u is the standard uncertainty of the test (k = 1)", worst_is),
      {{"quantity", false, true},
       {"values"},
       {"value", true, false, false, false, true},
       {"limit"},
       {"share of limit"},
       {"u"},
       {"verdict", false, false, false, false, true},
       {"where", false}});
  for (const ValuesOfQuantity& quantity : quantities) {
    if (quantity.worst != nullptr) {
      const Json& worst = *quantity.worst;
      table.add({shown(quantity.quantity), fmt::format("{}", quantity.values.size()), value_in_words(worst),
                 limit_in_words(worst), share_in_words(worst), u_in_words(worst), verdict_in_words(worst),
                 fmt::format("{}: {}", shown(text_in(worst, "placement")), features_of(worst))});
    }
  }
  sheet.table(table);
}

void write_errors_over_length(const std::vector<ValuesOfQuantity>& quantities, Sheet& sheet) {
  static constexpr const char* symbols[] = {"circle", "square-open", "diamond"};
  double largest = 0.0;
  std::vector<const ValuesOfQuantity*> lengths;
  for (const ValuesOfQuantity& quantity : quantities) {
    if (is_length(*quantity.values.front())) {
      lengths.push_back(&quantity);
      for (const Json* value : quantity.values) {
        largest = std::max(largest, std::abs(value->at("value_mm").get<double>()));
      }
    }
  }
  if (lengths.empty()) {
    return;
  }
  const DrawnUnit unit = drawn_unit(largest);
  Json series = Json::array(), bands = Json::array();
  std::size_t count = 0, drawn_count = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const DrawnLengths drawn_ones = drawn_lengths(*lengths[i], unit, symbols[i % std::size(symbols)]);
    series.push_back(drawn_ones.series);
    if (!drawn_ones.band.at("x").empty()) {
      bands.push_back(drawn_ones.band);
    }
    count += lengths[i]->values.size();
    drawn_count += drawn_ones.drawn_count;
  }
  sheet.figure(
      {"Errors of length over length",
       fmt::format("Measured less certified, {}; the largest is {} µm{}. {}{}", plural(count, "value"),
                   micrometres(largest), where_limits_differ(lengths),
                   bands.empty()
                       ? "No limit is stated."
                       : "Dashed lines: the limits (MPE); crosses: non-conformity proven; diamonds: neither proven.",
                   drawn_count == count ? "" : fmt::format(" {} are drawn.", drawn_count)),
       {{"kind", "lengths"}, {"unit", unit.name}, {"series", series}, {"bands", bands}}});
}

void write_places_explained(Sheet& sheet) { sheet.paragraph(std::string("Octant and reach: ") + places_are); }

void write_values(const ValuesOfQuantity& quantity, Sheet& sheet) {
  const auto rows = rows_of(quantity);
  const bool lengths = is_length(*quantity.values.front());
  html::Table table(fmt::format("{}: {}, µm", shown(quantity.quantity), plural(quantity.values.size(), "value")),
                    {{"placement", false, true},
                     {lengths ? "between" : "feature", false},
                     {"repeat", false, false, false, true},
                     {"certified, mm"},
                     {"at, °C"},
                     {"at reference, mm"},
                     {"value", true, false, false, false, true},
                     {"limit"},
                     {"u"},
                     {"°C", true, false, false, true},
                     {"verdict", false, false, false, false, true},
                     {"octant, reach", false}});
  for (const Json* row : rows) {
    const Json& value = *row;
    const double temperature = number_in(value.at("temperature_C"));
    const std::string name = shown(text_in(value, "placement"));
    const auto cells = {html::cell(or_dash(name)),
                        html::cell(features_of(value)),
                        html::cell(shown(or_dash(text_in(value, "repeat")))),
                        html::cell(mm(stated(value))),
                        html::cell(stated_at(value)),
                        html::text(mm(number_in(value.at("certified_mm")))),
                        html::text(value_in_words(value)),
                        limit_in_words(value),
                        u_in_words(value),
                        std::isfinite(temperature) ? fmt::format("{:.2f}", temperature) : "–",
                        html::text(verdict_in_words(value)),
                        html::cell(place_in_words(value.at("place")))};
    table.add_markup(cells, value.at("verdict") == "does_not_conform" ? "notable" : "");
  }
  sheet.table(table);
  if (rows.size() < quantity.values.size()) {
    sheet.paragraph(fmt::format("{} more, all nearer to zero against their limits, are in the JSON result.",
                                quantity.values.size() - rows.size()));
  }
}

}  // namespace artcal
