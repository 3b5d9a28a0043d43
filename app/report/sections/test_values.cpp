#include "app/report/sections/test_values.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "app/report/thinning.h"
#include "app/results/result_names.h"
#include "app/results/verification/standard_name.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

constexpr std::size_t max_rows = 330;   // of a quantity: the 300 lengths of a plate of 25 balls are all shown
constexpr int max_values_drawn = 1500;  // of a quantity

std::string limit_in_words(const RecordedValue& value) { return value.limit ? micrometres(*value.limit) : "–"; }

std::string features_of(const RecordedValue& value) {
  const std::string first = shown(value.first);
  return value.is_length() ? first + " – " + shown(value.second) : first;
}

std::string place_in_words(const Place& place) {
  std::string text = fmt::format("{}", place.octant);
  text += place.share_of_reach > 0.0 ? fmt::format(", {:.0f} %", 100.0 * place.share_of_reach) : "";
  text += place.above_base ? ", above the base" : "";
  text += place.joint_at_stop == 0 ? "" : fmt::format(", joint {} at its stop", place.joint_at_stop);
  return text;
}

std::string u_in_words(const RecordedValue& value) { return fmt::format("{:.2f}", 1000.0 * value.u); }

// The largest error need not be the worst value: limits grow with the length.
std::string where_limits_differ(const std::vector<const ValuesOfQuantity*>& lengths) {
  std::string text;
  for (const ValuesOfQuantity* quantity : lengths) {
    if (quantity->worst != nullptr && quantity->worst->limit) {
      text += fmt::format("; the largest share of its limit, {}, has {} with {} µm", share_in_words(*quantity->worst),
                          shown(quantity->quantity), value_in_words(*quantity->worst));
    }
  }
  return text;
}

// Results of earlier versions, and diameters, have the value at the reference temperature alone.
double stated(const RecordedValue& value) {
  return std::isfinite(value.stated) ? value.stated : value.certified.value_or(NAN);
}
std::string stated_at(const RecordedValue& value) {
  return std::isfinite(value.stated_at) ? fmt::format("{:.4g}", value.stated_at) : "–";
}

// All in their order, or the most severe first.
std::vector<const RecordedValue*> rows_of(const ValuesOfQuantity& quantity) {
  std::vector<const RecordedValue*> rows = quantity.values;
  if (rows.size() <= max_rows) {
    return rows;
  }
  const auto fails = [](const RecordedValue* value) { return value->verdict == Verdict::NonConformityProven; };
  std::stable_sort(rows.begin(), rows.end(), [&](const RecordedValue* a, const RecordedValue* b) {
    return std::pair(!fails(a), -a->severity()) < std::pair(!fails(b), -b->severity());
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
  for (const RecordedValue* value : quantity.values) {
    lengths.push_back(value->certified.value_or(NAN));
    errors.push_back(value->value);
    if (value->limit) {
      limits[lengths.back()] = *value->limit;
    }
  }
  Json x = Json::array(), y = Json::array(), names = Json::array(), verdicts = Json::array();
  const auto kept = thinned(lengths, errors, max_values_drawn);
  for (const int i : kept) {
    const RecordedValue& value = *quantity.values[i];
    x.push_back(drawn(lengths[i]));
    y.push_back(drawn(unit.per_mm * errors[i]));
    verdicts.push_back(result_name(value.verdict));
    names.push_back(shown(value.placement) + ": " + features_of(value) + ", " + verdict_in_words(value));
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

std::vector<ValuesOfQuantity> by_quantity(const std::vector<RecordedValue>& values) {
  std::vector<ValuesOfQuantity> quantities;
  std::map<std::string, std::size_t> places;
  for (const RecordedValue& value : values) {
    const auto [place, is_new] = places.try_emplace(value.quantity, quantities.size());
    if (is_new) {
      quantities.push_back({value.quantity, {}, nullptr});
    }
    ValuesOfQuantity& of_quantity = quantities[place->second];
    of_quantity.values.push_back(&value);
    if (!value.set_aside && (of_quantity.worst == nullptr || value.severity() > of_quantity.worst->severity())) {
      of_quantity.worst = &value;
    }
  }
  return quantities;
}

std::string verdict_in_words(const RecordedValue& value) {
  if (value.set_aside) {
    return "set aside";
  }
  switch (value.verdict) {
    case Verdict::ConformityProven: return "✓\u00a0conformity proven";
    case Verdict::NonConformityProven: return "✗\u00a0non\u2011conformity proven";
    case Verdict::NeitherProven: return "? neither proven";
    case Verdict::NotJudged: break;
  }
  return "not judged";
}

std::string value_in_words(const RecordedValue& value) {
  return deviation_micrometres(value.value, value.certified.has_value());
}

std::string share_in_words(const RecordedValue& value) {
  return value.limit ? fmt::format("{:.0f} %", 100.0 * value.severity()) : "–";
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
      const RecordedValue& worst = *quantity.worst;
      table.add({shown(quantity.quantity), fmt::format("{}", quantity.values.size()), value_in_words(worst),
                 limit_in_words(worst), share_in_words(worst), u_in_words(worst), verdict_in_words(worst),
                 fmt::format("{}: {}", shown(worst.placement), features_of(worst))});
    }
  }
  sheet.table(table);
}

void write_errors_over_length(const std::vector<ValuesOfQuantity>& quantities, Sheet& sheet) {
  static constexpr const char* symbols[] = {"circle", "square-open", "diamond"};
  double largest = 0.0;
  std::vector<const ValuesOfQuantity*> lengths;
  for (const ValuesOfQuantity& quantity : quantities) {
    if (quantity.values.front()->is_length()) {
      lengths.push_back(&quantity);
      for (const RecordedValue* value : quantity.values) {
        largest = std::max(largest, std::abs(value->value));
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
  const bool lengths = quantity.values.front()->is_length();
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
  for (const RecordedValue* row : rows) {
    const RecordedValue& value = *row;
    const auto cells = {html::cell(or_dash(shown(value.placement))),
                        html::cell(features_of(value)),
                        html::cell(shown(or_dash(value.repeat))),
                        html::cell(mm(stated(value))),
                        html::cell(stated_at(value)),
                        html::text(mm(value.certified.value_or(NAN))),
                        html::text(value_in_words(value)),
                        limit_in_words(value),
                        u_in_words(value),
                        std::isfinite(value.temperature) ? fmt::format("{:.2f}", value.temperature) : "–",
                        html::text(verdict_in_words(value)),
                        html::cell(place_in_words(value.place))};
    table.add_markup(cells, value.verdict == Verdict::NonConformityProven ? "notable" : "");
  }
  sheet.table(table);
  if (rows.size() < quantity.values.size()) {
    sheet.paragraph(fmt::format("{} more, all nearer to zero against their limits, are in the JSON result.",
                                quantity.values.size() - rows.size()));
  }
}

}  // namespace artcal
