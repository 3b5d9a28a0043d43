#include "app/report/sections/verification_section.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "app/report/scene.h"
#include "app/report/sections/beside_values.h"
#include "app/report/sections/test_values.h"
#include "app/results/verification/standard_name.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

std::size_t count_of(const std::vector<RecordedValue>& values, Verdict verdict) {
  return static_cast<std::size_t>(std::count_if(values.begin(), values.end(), [&](const RecordedValue& value) {
    return value.verdict == verdict && !value.set_aside;
  }));
}

std::vector<std::string> texts_in(const Json& list) { return list.get<std::vector<std::string>>(); }

void write_rules(const Json& result, Sheet& sheet) {
  sheet.facts({{"Standard", standard_in_words(text_in(result, "standard"))},
               {"Limits", shown(text_in(result, "specification", "none stated"))},
               {"Decision rule", text_in(result, "decision_rule")},
               {"Coordinates", result.at("tip_centres") == "reported" ? "as the arm's own software reported them"
                                                                      : "computed from joint angles"}});
}

}  // namespace

void write_verification_verdict(const Json& result, Sheet& sheet) {
  const std::string conclusion = result.at("conclusion");
  const std::vector<RecordedValue> values = recorded_values(result);
  const bool good = conclusion == "conformity_shown";
  const bool bad = conclusion == "non_conformity_shown";
  std::string text =
      fmt::format("{}: {}, conformity proven of {}, non-conformity of {}, neither of {}.",
                  standard_in_words(text_in(result, "standard")), plural(values.size(), "value"),
                  count_of(values, Verdict::ConformityProven), count_of(values, Verdict::NonConformityProven),
                  count_of(values, Verdict::NeitherProven));
  if (const auto not_judged = count_of(values, Verdict::NotJudged); not_judged > 0) {
    text += fmt::format(" {} were not judged.", not_judged);
  }
  if (!result.at("missing").empty()) {
    text += " The test is not complete: see below what is missing.";
  }
  sheet.verdict(good  ? Mood::Good
                : bad ? Mood::Bad
                      : Mood::Unsure,
                good  ? "✓ Conformity proven"
                : bad ? "✗ Non-conformity proven"
                      : "? Conformity not shown",
                text);
  if (!result.at("interim").is_null()) {
    write_interim_verdict(result.at("interim"), sheet);
  }
}

void write_verification(const Json& result, Sheet& sheet) {
  write_rules(result, sheet);
  if (!result.at("missing").empty()) {
    sheet.part("Missing for a proof of conformity");
    sheet.list(texts_in(result.at("missing")));
  }
  // Results of earlier versions do not have it.
  if (result.contains("waived") && !result.at("waived").empty()) {
    sheet.part("Waived by the specification");
    sheet.list(texts_in(result.at("waived")));
  }
  const std::vector<RecordedValue> values = recorded_values(result);
  const auto quantities = by_quantity(values);
  sheet.part("Values");
  write_worst_values(quantities, sheet);
  write_errors_over_length(quantities, sheet);
  if (!quantities.empty()) {
    sheet.figure(scene_of_verification(result));
  }
  write_beside_values(result, sheet);
  if (!quantities.empty()) {
    write_places_explained(sheet);
  }
  for (const ValuesOfQuantity& quantity : quantities) {
    write_values(quantity, sheet);
  }
}

}  // namespace artcal
