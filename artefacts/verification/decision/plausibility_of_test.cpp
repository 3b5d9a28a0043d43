#include "artefacts/verification/decision/plausibility_of_test.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "artefacts/artefact/plausibility.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// Data sheets of arms state some 10 um to 0.3 mm.
constexpr double min_limit = 0.0005;          // mm
constexpr double max_limit = 1.0;             // mm
constexpr double max_u = 0.1;                 // mm, of alignment and fixture
constexpr double max_u_temperature = 5.0;     // K
constexpr double max_range = 20'000.0;        // mm
constexpr double min_range = 100.0;           // mm
constexpr double max_ranges_per_reach = 2.5;  // a range is a diameter: twice the reach
constexpr double min_ranges_per_reach = 0.1;

void check_limits(const Verification& verification, std::vector<std::string>& found) {
  std::set<Quantity> said;
  for (const TestValue& value : verification.values) {
    if (value.limit && (*value.limit > max_limit || *value.limit < min_limit) && said.insert(value.quantity).second) {
      const std::string at = value.second.empty() ? "" : fmt::format(" at {:.0f} mm", value.certified);
      found.push_back(fmt::format("the limit of {} is {}{}, expected {} to {}; is units.limit right?",
                                  name_of(value.quantity), length_text(*value.limit), at, length_text(min_limit),
                                  length_text(max_limit)));
    }
  }
}

void check_rated_temperature(const std::optional<double>& temperature, const char* key,
                             std::vector<std::string>& found) {
  if (temperature && !is_room_temperature(*temperature)) {
    found.push_back(fmt::format("the specification's {} is {:.1f} degC{}, expected 0 to 50 degC", key, *temperature,
                                unit_of_temperature(*temperature)));
  }
}

void check_specification(const Session& session, std::vector<std::string>& found) {
  const Specification& by = session.specification;
  check_rated_temperature(by.lowest_temperature, "lowest_C", found);
  check_rated_temperature(by.highest_temperature, "highest_C", found);
  for (const auto& [u, key] : {std::pair{by.u_alignment, "alignment"}, std::pair{by.u_fixture, "fixture"}}) {
    if (u > max_u) {
      found.push_back(
          fmt::format("the specification's standard uncertainty `{}` is {}, expected {} at most; is "
                      "units.limit right?",
                      key, length_text(u), length_text(max_u)));
    }
  }
  if (by.u_temperature.value_or(0.0) > max_u_temperature) {
    found.push_back(
        fmt::format("the specification's standard uncertainty of the temperature is {} K, expected {} K at "
                    "most",
                    *by.u_temperature, max_u_temperature));
  }
  if (!by.measuring_range) {
    return;
  }
  const double whole = session.arm.joints.empty() ? 0.0 : reach(session.arm);
  const double lowest = whole > 0.0 ? min_ranges_per_reach * whole : min_range;
  const double highest = whole > 0.0 ? max_ranges_per_reach * whole : max_range;
  if (*by.measuring_range < lowest || *by.measuring_range > highest) {
    found.push_back(
        fmt::format("the specification's measuring_range is {}, expected {} to {}{}; is units.length right?",
                    length_text(*by.measuring_range), length_text(lowest), length_text(highest),
                    whole > 0.0 ? fmt::format(" (the arm reaches {})", length_text(whole)) : ""));
  }
}

}  // namespace

void check_plausibility(const Session& session, Verification& verification) {
  std::set<std::string> used;
  for (const TestValue& value : verification.values) {
    used.insert(value.artefact);
  }
  const auto report = [&](const std::vector<std::string>& found, const Subject& about) {
    for (const std::string& text : found) {
      report_missing(verification, session.specification, Evidence::PlausibleValues, text, about);
    }
  };
  std::vector<std::string> of_test;
  check_limits(verification, of_test);
  check_specification(session, of_test);
  report(of_test, {Subject::Kind::Test});
  const std::vector<Artefact>& artefacts = session.constraints.artefacts;
  for (std::size_t i = 0; i < artefacts.size(); ++i) {
    if (used.contains(artefacts[i].name)) {
      report(implausible_values(artefacts[i]), {Subject::Kind::Artefact, i});
    }
  }
  report(implausible_values(session.recording), {Subject::Kind::Recording});
}

}  // namespace artcal
