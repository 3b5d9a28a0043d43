// Reports of results that are not what they should be: refused or written, never a crash.
#include "app/report/report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <utility>

#include <gmock/gmock.h>

#include "acquisition/recording/recording_file.h"
#include "acquisition/recording/tip_centres.h"
#include "app/results/identification/readings_json.h"
#include "app/results/identification/result_json.h"
#include "app/results/result_head.h"
#include "app/results/verification/verification_json.h"
#include "artefacts/constraints/bound_recording.h"
#include "artefacts/verification/decision/specification_file.h"
#include "artefacts/verification/verify.h"
#include "identification/identify.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::Not;

BoundRecording bound_example(const std::string& name) {
  return bind_recording(
             read_recording(std::string(ARTCAL_SOURCE_DIR) + "/examples/" + name + "/recording.toml").value())
      .value();
}

Json identified() {
  const auto [recording, constraints] = bound_example("two-socket-bar");
  IdentifyOptions options;
  options.leave_out = false;
  const auto result = identify(recording, constraints, options).value();
  Json json = to_json(recording, constraints, options, result, {});
  json["residuals"] = residuals_json(recording, constraints, result);
  return json;
}

Json verified(const std::string& name, Standard standard) {
  const auto [recording, constraints] = bound_example(name);
  const auto specification = read_specification_file(recording.specification_path).value().specification;
  const auto tips = tip_centres(recording).value();
  const Session session{recording, constraints, recording.arm, tips, specification};
  return to_json(session, verify(session, standard).value());
}

// Puts something else in the place of each value, of lists the first: refused or written, never a crash.
void damage(const Json& whole, ResultKind kind, int least) {
  ASSERT_TRUE(report_html({{kind, whole, "result.json"}}));
  const Json flat = whole.flatten();
  Json damaged = whole;
  int damages = 0;
  for (const auto& [pointer, value] : flat.items()) {
    if (std::regex_search(pointer, std::regex("/[1-9]\\d*(/|$)"))) {
      continue;
    }
    for (const Json& other : {Json(), Json("text"), Json(-7), Json::array()}) {
      Json& place = damaged[Json::json_pointer(pointer)];
      const Json before = std::exchange(place, other);
      const auto page = report_html({{kind, damaged, "result.json"}});
      EXPECT_TRUE(page || page.error().code == ErrorCode::BadInput) << pointer;
      place = before;
      ++damages;
    }
  }
  EXPECT_GT(damages, least);
}

TEST(ReportOfVerification, IsRefusedOrWrittenWhateverIsDamaged) {
  for (const auto& [example, standard] :
       {std::pair("iso10360-12", Standard::Iso10360_12), std::pair("sphere-plate", Standard::SpherePlate)}) {
    Json whole = verified(example, standard);
    whole["values"] = Json(std::vector<Json>(whole["values"].begin(), whole["values"].begin() + 8));
    damage(whole, ResultKind::Verification, 150);
  }
}

TEST(ReportOfUncertainty, IsRefusedOrWrittenWhateverIsDamaged) {
  Json spread{{"count", 3}, {"rms_mm", 0.01}, {"quantile_95_mm", 0.02}, {"maximum_mm", 0.03}};
  Json whole = result_head("uncertainty");
  whole["arm"] = whole["probe"] = "one";
  whole["inputs"] = {{{"path", "arm.toml"}, {"sha256", "00"}}};
  whole["encoder_noise_rad"] = whole["probing_noise_mm"] = 0.001;
  whole["lengths"] = {{{"length_mm", 500.0}, {"u", spread}, {"u_of_the_arm", spread}}};
  whole["sphere_diameter"] = spread;
  whole["map"] = {{{"from_axis_mm", 100.0}, {"height_mm", 200.0}, {"u_of_a_point", spread}}};
  damage(whole, ResultKind::Uncertainty, 60);
}

Json whole_monte_carlo() {
  Json whole = result_head("monte-carlo");
  whole["recording"] = "three";
  whole["arm"] = "one";
  whole["inputs"] = {{{"path", "recording.toml"}, {"sha256", "00"}}};
  whole["seed"] = 7;
  whole["options"] = {{"noise", {{"reading_mm", nullptr}, {"encoder_rad", 1e-5}, {"probing_mm", 0.003}}},
                      {"probe", "tip"},
                      {"digits", 2}};
  whole["model"] = "dh";
  whole["trials"] = {{"made", 1000}, {"not_converged", 1}, {"complete", true}};
  const auto quantity = [](const char* kind, const char* name, const Json& first_order, double u, bool differs) {
    return Json{{"kind", kind},
                {"name", name},
                {"unit", "mm"},
                {"estimate", 100.0},
                {"u_first_order", first_order},
                {"u", u},
                {"interval_95", {99.9, 100.3}},
                {"stable", true},
                {"differs_from_first_order", differs}};
  };
  whole["quantities"] = {
      quantity("parameter", "d3", 0.0311, 0.0457, true), quantity("E_Uni", "500 mm, 1", 0.003, 0.006, false),
      quantity("E_Uni", "500 mm, 2", 0.004, 0.008, false), quantity("L_Dia", "1", nullptr, 0.009, false)};
  whole["warnings"] = {"the bar is warm"};
  return whole;
}

TEST(ReportOfMonteCarlo, HasTheUncertaintiesOfParametersAndMeasurands) {
  const std::string page = report_html({reported(whole_monte_carlo())}).value();
  for (const char* shown : {"Monte Carlo: three", "Identified 1000 times", ">d3<", ">0.031<", ">0.046<",
                            "E_Uni, 500 mm", "⚠ the bar is warm",
                            ">7.07<",  // µm: √((6² + 8²)/2)
                            ">3.54<", "not linear", "parameter d3: 1.47 times the first order", "2 digits"}) {
    EXPECT_THAT(page, HasSubstr(shown));
  }
}

TEST(ReportOfMonteCarlo, IsRefusedOrWrittenWhateverIsDamaged) {
  damage(whole_monte_carlo(), ResultKind::MonteCarlo, 90);
}

class PageOfVerification : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { whole_ = verified("iso10360-12", Standard::Iso10360_12); }
  static inline Json whole_;
};

TEST_F(PageOfVerification, NamesItsStandardWithItsYear) {
  const std::string page = report_html({reported(whole_)}).value();
  EXPECT_THAT(page, HasSubstr("<dd>ISO 10360-12:2016</dd>"));
  EXPECT_THAT(page, Not(HasSubstr("iso10360-12<")));
}

TEST_F(PageOfVerification, TheWorstValueIsThatWithTheLargestShareOfItsLimitAndThePageSaysSo) {
  Json result = whole_;
  Json length = result["values"].back();
  result["values"] = Json::array();
  const auto add = [&](double certified, double value, double limit) {
    length["certified_mm"] = certified;
    length["value_mm"] = value;
    length["limit_mm"] = limit;
    result["values"].push_back(length);
  };
  add(200.0, 0.0146, 0.0150);   // 97 % of a small limit
  add(1200.0, 0.0157, 0.0300);  // larger, and 52 % of its own
  const std::string page = report_html({reported(result)}).value();
  EXPECT_THAT(page, HasSubstr("the value with the largest share of its limit"));
  EXPECT_THAT(page, HasSubstr(">+14.6</td><td class=\"number\">15.0</td><td class=\"number\">97 %</td>"));
  EXPECT_THAT(page, HasSubstr("the largest is 15.7 µm; the largest share of its limit, 97 %, has E_Uni with +14.6 µm"));
}

TEST_F(PageOfVerification, ExplainsOctantsOnceBeforeTheyAreUsed) {
  const std::string page = report_html({reported(whole_)}).value();
  const std::size_t explained = page.find("octants are counted about the shoulder");
  ASSERT_NE(explained, std::string::npos);
  EXPECT_LT(explained, page.find(">octant, reach<"));
  EXPECT_EQ(page.find("octants are counted about the shoulder", explained + 1), std::string::npos);
}

TEST_F(PageOfVerification, ItsPictureShowsTheArtefacts) {
  ASSERT_GT(whole_["features"].size(), 30u) << "two balls, and seven placements of a bar";
  // The bar's certified lengths stand between the places of its features.
  std::map<std::string, std::vector<double>> at;
  for (const Json& feature : whole_["features"]) {
    if (feature["placement"] == "1") {
      at[feature["feature"]] = feature["at_mm"].get<std::vector<double>>();
    }
  }
  ASSERT_TRUE(at.contains("A") && at.contains("F"));
  double squares = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    squares += std::pow(at["F"][axis] - at["A"][axis], 2);
  }
  EXPECT_NEAR(std::sqrt(squares), 1200.0, 0.5);
  const std::string page = report_html({reported(whole_)}).value();
  EXPECT_THAT(page, HasSubstr("\"artefacts\":{\"dots\":{\"x\":["));
  EXPECT_THAT(page, HasSubstr("Squares: the features of the artefacts"));
  Json old = whole_;  // as an earlier version wrote it
  old.erase("features");
  EXPECT_TRUE(report_html({reported(old)}));
}

TEST_F(PageOfVerification, CarriesItsArmToEveryPageOfPaper) {
  Json result = whole_;
  result["arm"] = "arm \"17\"; } </style><script>alert(1)</script>";
  const std::string page = report_html({reported(result)}).value();
  EXPECT_THAT(page, HasSubstr("@bottom-left { content: \"Calibration report\\3a  arm \\22 17\\22 \\3b  "));
  EXPECT_THAT(page, Not(HasSubstr("</style><script>alert")));
}

class ReportOfIdentification : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    whole_ = identified();
    for (Json& column : whole_["residuals"]) {  // a few readings are enough
      if (column.empty()) {
        continue;  // no joint is prismatic
      }
      if (column[0].is_array()) {
        std::for_each(column.begin(), column.end(), [](Json& inner) { inner = first_of(inner); });
      } else {
        column = first_of(column);
      }
    }
  }
  static Json first_of(const Json& list) { return Json(std::vector<Json>(list.begin(), list.begin() + 20)); }

  static inline Json whole_;
};

TEST_F(ReportOfIdentification, IsWritten) {
  const auto page = report_html({reported(whole_)});
  ASSERT_TRUE(page);
  EXPECT_THAT(*page, HasSubstr("<h1>Calibration report: Franka Emika Panda</h1>"));
}

TEST_F(ReportOfIdentification, IsRefusedOrWrittenWhateverIsDamaged) { damage(whole_, ResultKind::Identification, 400); }

TEST_F(ReportOfIdentification, IsRefusedWhereColumnsDiffer) {
  for (const char* column : {"feature", "before_mm", "after_mm"}) {
    Json damaged = whole_;
    damaged["residuals"][column].erase(0);
    EXPECT_FALSE(report_html({reported(damaged)})) << column;
  }
  Json damaged = whole_;
  damaged["residuals"]["feature"][0] = 1'000'000;
  EXPECT_FALSE(report_html({reported(damaged)}));
}

// What was never held against readings of its own is not called good without a word.
TEST_F(ReportOfIdentification, SaysThatNothingWasLeftOut) {
  Json result = whole_;
  result["warnings"] = result["outliers"] = result["left_out"] = Json::array();
  EXPECT_THAT(report_html({reported(result)}).value(),
              ::testing::AllOf(HasSubstr("Nothing was left out for cross-validation"), Not(HasSubstr("✓ Identified"))));
  for (const char* judged : {"before", "after"}) {
    Json& placements = result[judged]["placements"];
    placements = Json(std::vector<Json>{placements[0]});
  }
  EXPECT_THAT(report_html({reported(result)}).value(),
              ::testing::AllOf(HasSubstr("Nothing could be left out for cross-validation, for there is one placement"),
                               Not(HasSubstr("✓ Identified"))));
  const Json placement = result["after"]["placements"][0];
  result["left_out"] = {{{"artefact", placement["artefact"]},
                         {"placement", placement["placement"]},
                         {"readings", 20},
                         {"rms_mm", 0.1},
                         {"maximum_mm", 0.2},
                         {"lengths", Json::array()},
                         {"refusal", nullptr}}};
  EXPECT_THAT(report_html({reported(result)}).value(), HasSubstr("✓ Identified"));
}

TEST_F(PageOfVerification, OfAnUnknownQuantityIsRefused) {
  Json result = whole_;
  result["values"][3]["quantity"] = "E_Tri";
  const auto page = report_html({{ResultKind::Verification, result, "v.json"}});
  ASSERT_FALSE(page);
  EXPECT_THAT(page.error().text(), HasSubstr("v.json: this result is not as --json wrote it: values[3].quantity is "
                                             "\"E_Tri\", expected P_Size"));
}

// A nominal arm that cannot be evaluated: null in the result, a dash in the report.
TEST(ReportOfResults, WithoutANominalEvaluationIsWritten) {
  const auto [recording, constraints] = bound_example("two-socket-bar");
  IdentifyOptions options;
  options.leave_out = false;
  auto result = identify(recording, constraints, options).value();
  result.before = not_evaluated(result.after);
  Json json = Json::parse(to_json(recording, constraints, options, result, {}).dump());
  json["residuals"] = Json::parse(residuals_json(recording, constraints, result).dump());
  EXPECT_TRUE(json["before"]["overall"]["rms_mm"].is_null());
  EXPECT_EQ(json["before"]["lengths"].size(), json["after"]["lengths"].size());
  const auto page = report_html({reported(json)});
  ASSERT_TRUE(page) << page.error().text();
  EXPECT_THAT(*page, HasSubstr("by the nominal arm – mm and – mm"));
}

TEST_F(ReportOfIdentification, OfTwoArmsIsRefused) {
  Json other = whole_;
  other["arm"] = "another";
  const auto page = report_html({reported(whole_), reported(other)});
  ASSERT_FALSE(page);
  EXPECT_EQ(page.error().code, ErrorCode::Usage);
  EXPECT_THAT(page.error().message, HasSubstr("another"));
}

TEST_F(ReportOfIdentification, ShowsWhatIsStated) {
  Json result = whole_;
  result["date"] = "2026-03-10";
  result["temperature"] = {{"lowest_C", 19.5}, {"highest_C", 21.25}};
  result["artefacts"][0]["certificate"] = {
      {"number", "K-17"}, {"laboratory", "Lab & Co"}, {"date", "2026-01-02"}, {"valid_until", nullptr}};
  result["warnings"] = {"the <bar> is warm"};
  const std::string page = report_html({reported(result)}).value();
  for (const char* shown : {"2026-03-10", "19.50 °C to 21.25 °C", "K-17", "Lab &amp; Co", "2026-01-02",
                            "the &lt;bar&gt; is warm", "Identified, with reservations"}) {
    EXPECT_THAT(page, HasSubstr(shown));
  }
}

}  // namespace
}  // namespace artcal
