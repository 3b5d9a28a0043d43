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

using namespace numbers;

std::size_t count_of(const std::vector<RecordedValue>& values, Verdict verdict) {
  return static_cast<std::size_t>(std::count_if(values.begin(), values.end(), [&](const RecordedValue& value) {
    return value.verdict == verdict && !value.set_aside;
  }));
}

void write_rules(const RecordedVerification& result, Sheet& sheet) {
  sheet.facts({{"Standard", standard_in_words(result.standard)},
               {"Limits", shown(result.specification.empty() ? "none stated" : result.specification)},
               {"Decision rule", result.decision_rule},
               {"Coordinates", result.is_of_reported_coordinates ? "as the arm's own software reported them"
                                                                 : "computed from joint angles"}});
}

}  // namespace

void write_verification_verdict(const RecordedVerification& result, Sheet& sheet) {
  const std::vector<RecordedValue>& values = result.values;
  const bool good = result.conclusion == Conclusion::ConformityProven;
  const bool bad = result.conclusion == Conclusion::NonConformityProven;
  std::string text = fmt::format(
      "{}: {}, conformity proven of {}, non-conformity of {}, neither of {}.", standard_in_words(result.standard),
      plural(values.size(), "value"), count_of(values, Verdict::ConformityProven),
      count_of(values, Verdict::NonConformityProven), count_of(values, Verdict::NeitherProven));
  if (const auto not_judged = count_of(values, Verdict::NotJudged); not_judged > 0) {
    text += fmt::format(" {} were not judged.", not_judged);
  }
  if (!result.missing.empty()) {
    text += " The test is not complete: see below what is missing.";
  }
  sheet.verdict(good  ? Mood::Good
                : bad ? Mood::Bad
                      : Mood::Unsure,
                good  ? "✓ Conformity proven"
                : bad ? "✗ Non-conformity proven"
                      : "? Conformity not shown",
                text);
  if (result.drifts) {
    write_interim_verdict(*result.drifts, sheet);
  }
}

void write_verification(const RecordedVerification& result, Sheet& sheet) {
  write_rules(result, sheet);
  if (!result.missing.empty()) {
    sheet.part("Missing for a proof of conformity");
    sheet.list(result.missing);
  }
  if (!result.waived.empty()) {
    sheet.part("Waived by the specification");
    sheet.list(result.waived);
  }
  const auto quantities = by_quantity(result.values);
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
