#include "app/report/over_time/drift.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr int parameter_count = 20;
constexpr double u = 0.001;

// An identification of which every parameter is `value`, each with standard uncertainty u.
Json identification(const std::string& date, const std::string& hash, double value) {
  Json json{{"kind", "identification"},
            {"date", date},
            {"inputs", {{{"path", "r.toml"}, {"sha256", hash}}}},
            {"coupling", {{"angle_scale_mm", 1000.0}, {"unidentifiable", Json::array()}}}};
  for (int i = 0; i < parameter_count; ++i) {
    const std::string name = "p" + std::to_string(i);
    json["parameters"].push_back({{"name", name},
                                  {"unit", i % 2 == 0 ? "mm" : "rad"},
                                  {"state", "identified"},
                                  {"identified", value},
                                  {"standard_uncertainty", u}});
    json["covariance"]["parameters"].push_back(name);
    json["covariance"]["matrix"].push_back(std::vector<double>(parameter_count, 0.0));
    json["covariance"]["matrix"][i][i] = u * u;
  }
  return json;
}

Json verification(const std::string& date, double largest, bool set_aside = false) {
  Json json{{"kind", "verification"}, {"date", date}, {"standard", "iso10360-12"}};
  const Json place{{"point_mm", {500.0, 0.0, 0.0}},
                   {"octant", 1},
                   {"share_of_reach", 0.5},
                   {"above_base", true},
                   {"joint_at_stop", nullptr}};
  for (const double error : {0.001, -largest}) {
    json["values"].push_back({{"quantity", "E_Uni"},
                              {"artefact", "bar"},
                              {"placement", "1"},
                              {"first", "A"},
                              {"second", "B"},
                              {"repeat", "1"},
                              {"certified_mm", 500.0},
                              {"value_mm", error},
                              {"limit_mm", 0.03},
                              {"u_mm", 0.002},
                              {"verdict", largest < 0.03 ? "conforms" : "does_not_conform"},
                              {"set_aside", set_aside && error < 0.0},
                              {"place", place}});
  }
  return json;
}

std::string page_of(const std::vector<Json>& results) {
  std::vector<ReportedResult> all;
  for (const Json& json : results) {
    all.push_back(reported(json));
  }
  Sheet sheet;
  write_drift(all, sheet);
  return sheet.markup();
}

long significant_in(const std::string& page) {
  long found = 0;
  for (auto at = page.find("⚠ significant"); at != std::string::npos; at = page.find("⚠ significant", at + 1)) {
    ++found;
  }
  return found;
}

TEST(Drift, OfOneResultIsNotTold) { EXPECT_THAT(page_of({identification("2026-01-01", "a", 0.0)}), IsEmpty()); }

// With u of a change √2·u, and 20 parameters of which one by chance in twenty comparisons lies outside:
// the quantile 1 - 0.025/20 of the normal distribution is 3.023.
TEST(Drift, IsSignificantBeyondChance) {
  Json later = identification("2026-02-01", "b", 0.0);
  later["parameters"][3]["identified"] = 3.1 * 1.41421356 * u;
  later["parameters"][4]["identified"] = -3.1 * 1.41421356 * u;
  later["parameters"][5]["identified"] = 2.95 * 1.41421356 * u;
  const std::string page = page_of({identification("2026-01-01", "a", 0.0), later});
  EXPECT_EQ(significant_in(page), 2);
  EXPECT_THAT(page, HasSubstr("beyond 3.0 u"));
  EXPECT_THAT(page, Not(HasSubstr("same recording")));
}

TEST(Drift, GoesByDateWhateverTheOrder) {
  const std::string page = page_of({identification("2026-05-01", "b", 2.0), identification("2026-01-01", "a", 1.0)});
  EXPECT_THAT(page, HasSubstr("From 2026-01-01 to 2026-05-01"));
  EXPECT_THAT(page, HasSubstr(">+1.00000<"));
}

TEST(Drift, OfParametersThatWereHeldDifferentlyIsNotTold) {
  Json other = identification("2026-02-01", "b", 5.0);
  other["parameters"][0]["state"] = "fixed";
  other["covariance"]["parameters"].erase(0);
  other["covariance"]["matrix"].erase(0);
  for (Json& row : other["covariance"]["matrix"]) row.erase(0);
  const std::string page = page_of({identification("2026-01-01", "a", 0.0), other});
  EXPECT_THAT(page, HasSubstr("cannot be compared one by one"));
  EXPECT_EQ(significant_in(page), 0);
}

// Parameter p1 is an angle at the end of a link l of 183.5 mm, beside a6, which no reading tells apart from it.
Json with_a6(Json json, double a6) {
  const double l = 183.5;
  json["parameters"].push_back(
      {{"name", "a6"}, {"unit", "mm"}, {"state", "fixed"}, {"identified", a6}, {"standard_uncertainty", nullptr}});
  json["coupling"]["unidentifiable"].push_back(
      {{"fixed", "a6"}, {"text", ""}, {"motion", {{"a6", 1.0}, {"p1", -1.0 / l}, {"p0", -a6 / l}}}});
  return json;
}

// The same arm identified from a nominal arm with a6 = 0 and with 5 mm: the angle differs by atan(5/183.5), the length
// by 183.5 - sqrt(183.5² - 5²) = 0.0681 mm. Nothing has drifted but p3.
TEST(Drift, OfParametersWhosePartnersWereFixedElsewhereIsToldInOneGauge) {
  Json first = with_a6(identification("2026-01-01", "a", 0.0), 0.0);
  Json second = with_a6(identification("2026-02-01", "b", 0.0), 5.0);
  second["parameters"][1]["identified"] = -std::asin(5.0 / 183.5);
  second["parameters"][0]["identified"] = std::sqrt(183.5 * 183.5 - 25.0) - 183.5;
  second["parameters"][3]["identified"] = 10.0 * u;
  const std::string page = page_of({first, second});
  EXPECT_THAT(page, HasSubstr("a6 was fixed at different values"));
  EXPECT_EQ(significant_in(page), 1);
  // Where nothing says that no reading sees the difference, it is not determined.
  second["coupling"]["unidentifiable"].clear();
  const std::string other = page_of({first, second});
  EXPECT_THAT(other, HasSubstr("a6 was fixed at 0 and then at 5 mm"));
  EXPECT_EQ(significant_in(other), 0);
}

// Two results of noise with one degree of freedom each: two together, and for twenty parameters 20.0 u, not 3.0
// (scipy 1.10, t.isf(0.025/20, 2)).
TEST(Drift, CountsTheDegreesOfFreedom) {
  Json first = identification("2026-01-01", "a", 0.0);
  Json later = identification("2026-02-01", "b", 0.0);
  for (Json* json : {&first, &later}) {
    for (Json& parameter : (*json)["parameters"]) parameter["degrees_of_freedom"] = 1.0;
  }
  later["parameters"][3]["identified"] = 19.0 * 1.41421356 * u;
  EXPECT_EQ(significant_in(page_of({first, later})), 0);
  later["parameters"][3]["identified"] = 21.0 * 1.41421356 * u;
  EXPECT_EQ(significant_in(page_of({first, later})), 1);
}

TEST(Drift, OfVerificationsIsThatOfTheirWorstValues) {
  const std::string page = page_of({verification("2027-01-01", 0.05), verification("2026-01-01", 0.02)});
  const auto then = page.find("2026-01-01</td><td class=\"number\">-20.0</td>");
  const auto now = page.find("2027-01-01</td><td class=\"number\">-50.0</td>");
  EXPECT_NE(then, std::string::npos) << page;
  EXPECT_NE(now, std::string::npos);
  EXPECT_LT(then, now);
  EXPECT_THAT(page, HasSubstr("✗\u00a0non\u2011conformity proven"));
  EXPECT_THAT(page_of({verification("2026-01-01", 0.02), verification("2027-01-01", 0.05, true)}),
              HasSubstr(">+1.0</td>"));  // what was measured again does not count
}

TEST(Drift, OfVerificationsByTwoStandardsIsNotTold) {
  Json other = verification("2027-01-01", 0.05);
  other["standard"] = "sphere-plate";
  EXPECT_THAT(page_of({verification("2026-01-01", 0.02), other}), IsEmpty());
}

TEST(Drift, OfTheSameRecordingIsDoubted) {
  EXPECT_THAT(page_of({identification("2026-01-01", "a", 0.0), identification("2026-01-02", "a", 1.0)}),
              HasSubstr("are of the same recording"));
}

}  // namespace
}  // namespace artcal
