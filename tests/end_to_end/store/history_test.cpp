// What laboratories ask of a store about one arm, or one certificate.
#include <cmath>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/archive.h"
#include "tests/end_to_end/browser.h"

namespace artcal {
namespace {

using testing::count_of;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

class History : public testing::Browsing<testing::ArchiveTest> {
 protected:
  void SetUp() override {
    const auto test = [&](const std::string& name, const std::string& date, const std::string& number) {
      file_away("iso10360-12", name, "date = " + date + "\n");
      const std::string bar = "archive/" + name + "/bar.toml";
      write(bar, with_certificate(text_of(bar), "number = \"" + number + "\"\nlaboratory = \"Example Laboratory\"\n"));
    };
    test("first", "2026-03-01", "4711");
    test("second", "2026-06-01", "4711");
    test("bumped", "2026-09-01", "4712");
    // The same name, another truth.
    std::string arm = text_of("archive/bumped/bumped-arm.toml");
    const auto name_of = [](const std::string& text) {
      const std::size_t at = text.find("\nname = ");
      return at == std::string::npos ? std::string() : text.substr(at, text.find('\n', at + 1) - at);
    };
    const std::string as_named = name_of(text_of("archive/bumped/arm.toml"));
    replace_in(arm, name_of(arm), as_named);
    write("archive/bumped/arm.toml", arm);
    arm_ = as_named.substr(as_named.find('"') + 1, as_named.rfind('"') - as_named.find('"') - 1);
    file_away("two-socket-bar", "robot-1", "date = 2025-01-01\n");
    file_away("two-socket-bar", "robot-2", "date = 2026-01-01\n");
    ASSERT_EQ(batch({"--store", "s.sqlite", "-q"}).exit_code, 1);
  }
  std::string arm_;
};

TEST_F(History, ABumpedArmIsSeenAndAnUnchangedOneIsNot) {
  const Ended ended = run({"history", arm_, "--store", "s.sqlite"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("ISO 10360-12:2016 from 2026-03-01 to 2026-06-01: no significant change of"));
  EXPECT_THAT(ended.out, HasSubstr("ISO 10360-12:2016 from 2026-06-01 to 2026-09-01: "));
  EXPECT_THAT(ended.out, HasSubstr(" values changed significantly; "));
  const Json json = Json::parse(run({"history", arm_, "--store", "s.sqlite", "--json", "-"}).out);
  EXPECT_EQ(json["verifications"].size(), 3u);
  EXPECT_EQ(json["verifications"][2]["conclusion"], "non_conformity_shown");
  ASSERT_EQ(json["value_steps"].size(), 2u);
  EXPECT_EQ(json["value_steps"][0]["certificates_in_common"].size(), 2u) << "the ball, and 4711";
  EXPECT_EQ(json["value_steps"][1]["certificates_in_common"].size(), 1u) << "the ball";
}

TEST_F(History, EveryErrorIsThereOverTimeWithItsUncertainty) {
  const Ended ended =
      run({"history", arm_, "--store", "s.sqlite", "--json", "history.json", "--report", "history.html"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("Values over time"));
  // What artcal verify says of the same recordings.
  const std::map<std::string, std::string> dates{
      {"2026-03-01", "first"}, {"2026-06-01", "second"}, {"2026-09-01", "bumped"}};
  const Json history = Json::parse(text_of("history.json"));
  std::map<std::string, Json> verified;
  for (const auto& [date, name] : dates) {
    const Ended one = run({"verify", "archive/" + name + "/recording.toml", "--json", "-"});
    verified[date] = Json::parse(one.out)["values"];
  }
  int compared = 0;
  ASSERT_EQ(history["values_over_time"].size(), 41u) << "35 lengths, and three values each of two balls";
  for (const Json& value : history["values_over_time"]) {
    ASSERT_EQ(value["points"].size(), 3u);
    for (const Json& point : value["points"]) {
      double sum = 0.0, u_test = 0.0;
      int repeats = 0;
      for (const Json& one : verified[point["date"]]) {
        bool same = true;
        for (const char* key : {"quantity", "artefact", "placement", "first", "second"}) {
          same = same && one[key] == value[key];
        }
        if (same) {
          sum += one["value_mm"].get<double>();
          // What the points add is in the scatter of the repeats already.
          u_test =
              std::sqrt(std::pow(one["u_mm"].get<double>(), 2) - std::pow(one["budget"]["points_mm"].get<double>(), 2));
          ++repeats;
        }
      }
      ASSERT_EQ(point["repeats"], repeats);
      EXPECT_NEAR(point["mean_mm"].get<double>(), sum / repeats, 1e-12);
      EXPECT_GE(point["u_mm"].get<double>(), u_test * (1.0 - 1e-9));
      ++compared;
    }
  }
  EXPECT_EQ(compared, 3 * 41);
  const testing::Opened opened = open("history.html");
  EXPECT_THAT(opened.complaints, ::testing::IsEmpty());
  EXPECT_THAT(opened.document, HasSubstr("data-drawn=\"all\""));
  EXPECT_THAT(opened.document, HasSubstr("✗ ISO 10360-12:2016, 2026-09-01: non-conformity proven"));
  EXPECT_EQ(count_of(opened.document, "role=\"img\" aria-label=\""), 5) << "the worst, and each of four quantities";
  EXPECT_THAT(opened.document, HasSubstr("E_Uni over time"));
}

TEST_F(History, ASlowDriftIsSeenOverAllWhereNoStepShowsIt) {
  for (int i = 0; i < 3; ++i) {
    const std::string name = fmt::format("slow-{}", i);
    file_away("two-socket-bar", name, fmt::format("date = 202{}-01-01\n", i + 1));
    change("archive/" + name + "/arm.toml", "name = \"Franka Emika Panda\"", "name = \"slow <b>\"");
    std::istringstream lines(text_of("archive/" + name + "/readings.csv"));
    std::string moved;
    std::getline(lines, moved);
    const auto column = std::count(moved.begin(), moved.begin() + static_cast<std::ptrdiff_t>(moved.find("q4")), ',');
    moved += "\n";
    for (std::string line; std::getline(lines, line);) {
      std::size_t begin = 0;
      for (int k = 0; k < column; ++k) {
        begin = line.find(',', begin) + 1;
      }
      const std::size_t end = line.find(',', begin);
      // An encoder that slips by 0.1 mrad a year.
      const double angle = std::stod(line.substr(begin, end - begin)) + 1e-4 * i;
      moved += line.substr(0, begin) + fmt::format("{}", angle) + line.substr(end) + "\n";
    }
    write("archive/" + name + "/readings.csv", moved);
  }
  ASSERT_EQ(batch({"--store", "s.sqlite", "--resume", "-q"}).exit_code, 1);
  const Ended ended = run({"history", "slow <b>", "--store", "s.sqlite", "--json", "h.json", "--report", "h.html"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(count_of(ended.out, ": no significant change (chi squared"), 2) << ended.out;
  EXPECT_THAT(ended.out, HasSubstr("Parameters from 2021-01-01 to 2023-01-01: CHANGED"));
  const Json history = Json::parse(text_of("h.json"));
  EXPECT_TRUE(history["parameters_overall"]["significant"]);
  for (const Json& parameter : history["parameters_over_time"]) {
    if (parameter["name"] == "theta4") {
      const Json& points = parameter["points"];
      EXPECT_NEAR(points[2]["value"].get<double>() - points[0]["value"].get<double>(), -2e-4, 1e-6);
      EXPECT_GT(points[0]["u"].get<double>(), 0.0);
    }
  }
  const std::string page = text_of("h.html");
  EXPECT_THAT(page, HasSubstr("⚠ Parameters drift"));
  EXPECT_THAT(page, Not(HasSubstr("slow <b>")));
  const testing::Opened opened = open("h.html");
  EXPECT_THAT(opened.complaints, ::testing::IsEmpty());
  EXPECT_THAT(opened.document, HasSubstr("data-drawn=\"all\""));
  EXPECT_THAT(opened.document, HasSubstr("Drift of parameters in arcsec"));
}

TEST_F(History, SaysFirstWhatChangedByHowMuchInLengthsAndOnWhichDay) {
  const Ended ended = run({"history", arm_, "--store", "s.sqlite", "--report", "h.html"});
  const std::string begin = ended.out.substr(0, ended.out.find("verification  "));
  EXPECT_THAT(begin, HasSubstr("What changed\n  ! ISO 10360-12:2016: largest change, E_Uni "));
  EXPECT_THAT(begin, HasSubstr("on 2026-09-01 (since 2026-06-01); 1 of 2 steps"));
  const std::string page = text_of("h.html");
  const std::size_t first = page.find("What changed</h3>");
  ASSERT_NE(first, std::string::npos);
  EXPECT_LT(first, page.find("class=\"verdict"));
  const Ended robot = run({"history", "Franka Emika Panda", "--store", "s.sqlite"});
  EXPECT_THAT(robot.out,
              HasSubstr("What changed\n  - Parameters: no significant change, the largest, measured lengths by up "
                        "to 0.0 um"));
}

TEST_F(History, TheSameReadingsTwiceAreNoChange) {
  const Ended ended = run({"history", "Franka Emika Panda", "--store", "s.sqlite"});
  EXPECT_THAT(ended.out, HasSubstr("Parameters from 2025-01-01 to 2026-01-01: no significant change (chi squared 0 "));
  EXPECT_THAT(run({"history", "Franka Emika Panda", "--store", "s.sqlite", "--all"}).out, HasSubstr("theta4"));
}

TEST_F(History, ARecalledCertificateNamesEveryResult) {
  const Ended ended = run({"history", "--certificate", "4711", "--store", "s.sqlite"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("Results that rest on certificate \"4711\": 2"));
  EXPECT_THAT(ended.out, HasSubstr("archive/first/recording.toml"));
  EXPECT_THAT(ended.out, HasSubstr("archive/second/recording.toml"));
  EXPECT_THAT(ended.out, Not(HasSubstr("archive/bumped")));
  EXPECT_THAT(run({"history", "--certificate", "1", "--store", "s.sqlite"}).err, HasSubstr("no result rests on"));
}

TEST_F(History, ARecallListIsJsonCsvAndPageToo) {
  const Ended ended = run({"history", "--certificate", "4711", "--store", "s.sqlite", "--json", "-", "--csv",
                           "recall.csv", "--report", "recall.html"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_EQ(json["kind"], "certificate-uses");
  ASSERT_EQ(json["results"].size(), 2u);
  const std::string csv = text_of("recall.csv");
  EXPECT_THAT(csv, ::testing::StartsWith("arm,date,recording,artefact,laboratory,file\n"));
  const std::string page = text_of("recall.html");
  for (const auto& result : json["results"]) {
    EXPECT_THAT(csv, HasSubstr(result["file"].get<std::string>()));
    EXPECT_THAT(page, HasSubstr("Example Laboratory"));
    EXPECT_THAT(page, HasSubstr(result["date"].get<std::string>()));
  }
  EXPECT_EQ(run({"history", "--certificate", "4711", "--store", "s.sqlite", "--csv", "s.sqlite"}).exit_code, 2);
}

TEST_F(History, WrongCallsAreRefused) {
  const Ended unknown = run({"history", "arm 99", "--store", "s.sqlite"});
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_THAT(unknown.err, HasSubstr("\"Franka Emika Panda\""));
  EXPECT_EQ(run({"history", "--store", "s.sqlite"}).exit_code, 2);
  EXPECT_EQ(run({"history", "arm", "--certificate", "1", "--store", "s.sqlite"}).exit_code, 2);
  EXPECT_EQ(run({"history", arm_, "--csv", "h.csv", "--store", "s.sqlite"}).exit_code, 2);
  EXPECT_EQ(run({"history", "arm", "--store", "gone.sqlite"}).exit_code, 3);
  const std::string before = text_of("s.sqlite");
  EXPECT_EQ(run({"history", arm_, "--report", "s.sqlite", "--store", "s.sqlite"}).exit_code, 2);
  EXPECT_TRUE(text_of("s.sqlite") == before) << "the store is not overwritten";
}

}  // namespace
}  // namespace artcal
