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
LengthKey key_of(const RecordedLength& length) {
  return {length.artefact, length.placement, length.first, length.second};
}

// Lengths by an arm identified without their placement.
std::map<LengthKey, const RecordedLength*> left_out_lengths(const std::vector<RecordedLeftOut>& left_out) {
  std::map<LengthKey, const RecordedLength*> lengths;
  for (const RecordedLeftOut& left : left_out) {
    for (const RecordedLength& length : left.lengths) {
      lengths.emplace(key_of(length), &length);
    }
  }
  return lengths;
}

Figure figure_of(const std::vector<RecordedLength>& after, const std::vector<const RecordedLength*>& left_out) {
  double largest = 0.0;
  for (const RecordedLength& length : after) {
    largest = std::max(largest, std::abs(length.error));
  }
  for (const RecordedLength* left : left_out) {
    largest = std::max(largest, left == nullptr ? 0.0 : std::abs(left->error));
  }
  const bool any_left_out =
      std::any_of(left_out.begin(), left_out.end(), [](const RecordedLength* left) { return left != nullptr; });
  const DrawnUnit unit = drawn_unit(largest);
  Json x = Json::array(), fitted = Json::array(), unseen = Json::array(), names = Json::array();
  for (std::size_t i = 0; i < after.size(); ++i) {
    const RecordedLength& length = after[i];
    x.push_back(length.at_temperature);
    fitted.push_back(drawn(unit.per_mm * length.error));
    unseen.push_back(left_out[i] == nullptr ? Json(nullptr) : drawn(unit.per_mm * left_out[i]->error));
    names.push_back(shown(fmt::format("{}: {} – {}", length.placement, length.first, length.second)));
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

void write_length_errors(const RecordedEvaluation& before, const RecordedEvaluation& after,
                         const std::vector<RecordedLeftOut>& left_out, Sheet& sheet) {
  html::Table table("Certified lengths as the arm measures them, errors in mm",
                    {{"placement", false, true},
                     {"between", false},
                     {"certified"},
                     {"at, °C"},
                     {"at temperature"},
                     {"before"},
                     {"after"},
                     {"cross-val.", true, false, false, true}});
  const auto without_placement = left_out_lengths(left_out);
  std::vector<const RecordedLength*> unseen;  // null where there is none
  for (std::size_t i = 0; i < after.lengths.size(); ++i) {
    const RecordedLength& length = after.lengths[i];
    const auto left = without_placement.find(key_of(length));
    unseen.push_back(left == without_placement.end() ? nullptr : left->second);
    table.add({shown(length.placement), shown(length.first) + " – " + shown(length.second),
               length.certified ? mm(*length.certified) : "–",
               length.certified_at ? fmt::format("{:.4g}", *length.certified_at) : "–", mm(length.at_temperature),
               signed_mm(before.lengths[i].error), signed_mm(length.error),
               unseen.back() == nullptr ? "–" : signed_mm(unseen.back()->error)});
  }
  sheet.part("Certified lengths");
  sheet.figure(figure_of(after.lengths, unseen));
  sheet.table(table);
}

}  // namespace artcal
