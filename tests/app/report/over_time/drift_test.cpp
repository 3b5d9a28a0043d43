#include "app/report/over_time/drift.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr int parameter_count = 20;
constexpr double u = 0.001;

RecordedResult dated_result(const std::string& date, const std::string& hash) {
  RecordedResult result;
  result.head.date = date;
  result.head.inputs = {{"r.toml", hash}};
  return result;
}

// An identification of which every parameter is `value`, each with standard uncertainty u.
RecordedResult identification(const std::string& date, const std::string& hash, double value) {
  RecordedIdentification content;
  content.identifiability.angle_scale = 1000.0;
  for (int i = 0; i < parameter_count; ++i) {
    const std::string name = "p" + std::to_string(i);
    content.parameters.push_back({name, i % 2 == 0 ? "mm" : "rad", 0.0, value, ParameterState::Identified, u});
    content.covariance.parameters.push_back(name);
  }
  content.covariance.matrix = u * u * Eigen::MatrixXd::Identity(parameter_count, parameter_count);
  RecordedResult result = dated_result(date, hash);
  result.content = content;
  return result;
}

RecordedIdentification& identified(RecordedResult& result) { return std::get<RecordedIdentification>(result.content); }
RecordedParameter& parameter(RecordedResult& result, std::size_t i) { return identified(result).parameters[i]; }

RecordedResult verification(const std::string& date, double largest, bool set_aside = false) {
  RecordedVerification content;
  content.standard = "iso10360-12";
  for (const double error : {0.001, -largest}) {
    RecordedValue value;
    value.quantity = "E_Uni";
    value.artefact = "bar";
    value.placement = value.repeat = "1";
    value.first = "A";
    value.second = "B";
    value.certified = 500.0;
    value.value = error;
    value.limit = 0.03;
    value.u = 0.002;
    value.verdict = largest < 0.03 ? Verdict::ConformityProven : Verdict::NonConformityProven;
    value.set_aside = set_aside && error < 0.0;
    content.values.push_back(value);
  }
  RecordedResult result = dated_result(date, "v");
  result.content = content;
  return result;
}

std::string page_of(const std::vector<RecordedResult>& results) {
  Sheet sheet;
  write_drift(results, sheet);
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
  RecordedResult later = identification("2026-02-01", "b", 0.0);
  parameter(later, 3).identified = 3.1 * 1.41421356 * u;
  parameter(later, 4).identified = -3.1 * 1.41421356 * u;
  parameter(later, 5).identified = 2.95 * 1.41421356 * u;
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
  RecordedResult other = identification("2026-02-01", "b", 5.0);
  parameter(other, 0).state = ParameterState::Fixed;
  RecordedCovariance& covariance = identified(other).covariance;
  covariance.parameters.erase(covariance.parameters.begin());
  covariance.matrix = u * u * Eigen::MatrixXd::Identity(parameter_count - 1, parameter_count - 1);
  const std::string page = page_of({identification("2026-01-01", "a", 0.0), other});
  EXPECT_THAT(page, HasSubstr("cannot be compared one by one"));
  EXPECT_EQ(significant_in(page), 0);
}

// Parameter p1 is an angle at the end of a link l of 183.5 mm, beside a6, which no reading tells apart from it.
RecordedResult with_a6(RecordedResult result, double a6) {
  const double l = 183.5;
  identified(result).parameters.push_back({"a6", "mm", a6, a6, ParameterState::Fixed});
  identified(result).identifiability.unidentifiable.push_back(
      {"a6", "", {{"a6", 1.0}, {"p1", -1.0 / l}, {"p0", -a6 / l}}});
  return result;
}

// The same arm identified from a nominal arm with a6 = 0 and with 5 mm: the angle differs by atan(5/183.5), the length
// by 183.5 - sqrt(183.5² - 5²) = 0.0681 mm. Nothing has drifted but p3.
TEST(Drift, OfParametersWhosePartnersWereFixedElsewhereIsToldInOneGauge) {
  const RecordedResult first = with_a6(identification("2026-01-01", "a", 0.0), 0.0);
  RecordedResult second = with_a6(identification("2026-02-01", "b", 0.0), 5.0);
  parameter(second, 1).identified = -std::asin(5.0 / 183.5);
  parameter(second, 0).identified = std::sqrt(183.5 * 183.5 - 25.0) - 183.5;
  parameter(second, 3).identified = 10.0 * u;
  const std::string page = page_of({first, second});
  EXPECT_THAT(page, HasSubstr("a6 was fixed at different values"));
  EXPECT_EQ(significant_in(page), 1);
  // Where nothing says that no reading sees the difference, it is not determined.
  identified(second).identifiability.unidentifiable.clear();
  const std::string other = page_of({first, second});
  EXPECT_THAT(other, HasSubstr("a6 was fixed at 0 and then at 5 mm"));
  EXPECT_EQ(significant_in(other), 0);
}

// Two results of noise with one degree of freedom each: two together, and for twenty parameters 20.0 u, not 3.0
// (scipy 1.10, t.isf(0.025/20, 2)).
TEST(Drift, CountsTheDegreesOfFreedom) {
  RecordedResult first = identification("2026-01-01", "a", 0.0);
  RecordedResult later = identification("2026-02-01", "b", 0.0);
  for (RecordedResult* result : {&first, &later}) {
    for (RecordedParameter& each : identified(*result).parameters) each.degrees_of_freedom = 1.0;
  }
  parameter(later, 3).identified = 19.0 * 1.41421356 * u;
  EXPECT_EQ(significant_in(page_of({first, later})), 0);
  parameter(later, 3).identified = 21.0 * 1.41421356 * u;
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
  RecordedResult other = verification("2027-01-01", 0.05);
  std::get<RecordedVerification>(other.content).standard = "sphere-plate";
  EXPECT_THAT(page_of({verification("2026-01-01", 0.02), other}), IsEmpty());
}

TEST(Drift, OfTheSameRecordingIsDoubted) {
  EXPECT_THAT(page_of({identification("2026-01-01", "a", 0.0), identification("2026-01-02", "a", 1.0)}),
              HasSubstr("are of the same recording"));
}

}  // namespace
}  // namespace artcal
