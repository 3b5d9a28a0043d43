#include "artefacts/verification/decision/outlier_rule.h"

#include <map>
#include <tuple>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using Set = std::vector<TestValue*>;

bool conforms(const TestValue& value) { return value.verdict == Verdict::ConformityProven; }

// The bad ones among the first `repeats` values, if all that come after them are good and enough.
Set excusable(const OutlierRule& rule, const Set& set, std::size_t repeats) {
  Set bad;
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (conforms(*set[i])) {
      continue;
    }
    if (i >= repeats) {
      return {};
    }
    bad.push_back(set[i]);
  }
  const bool few = static_cast<int>(bad.size()) <= rule.values;
  const bool repeated = set.size() >= repeats + static_cast<std::size_t>(rule.again);
  return few && repeated ? bad : Set{};
}

}  // namespace

void set_outliers_aside(const OutlierRule& rule, int repeats, Verification& verification) {
  if (rule.sets == 0) {
    return;
  }
  using Key = std::tuple<Quantity, std::string, std::string, std::string, std::string>;
  std::map<Key, Set> sets;
  for (TestValue& value : verification.values) {
    if (!value.second.empty()) {
      sets[{value.quantity, value.artefact, value.placement, value.first, value.second}].push_back(&value);
    }
  }
  std::vector<Set> excused;
  for (const auto& [key, set] : sets) {
    if (Set bad = excusable(rule, set, static_cast<std::size_t>(repeats)); !bad.empty()) {
      excused.push_back(std::move(bad));
    }
  }
  if (static_cast<int>(excused.size()) > rule.sets) {
    verification.warnings.push_back(fmt::format(
        "{} lengths would need the outlier rule, which allows {}: none is set aside", excused.size(), rule.sets));
    return;
  }
  for (const Set& bad : excused) {
    for (TestValue* value : bad) {
      value->set_aside = true;
      verification.warnings.push_back("set aside by the outlier rule: " + label_of(*value));
    }
  }
}

}  // namespace artcal
