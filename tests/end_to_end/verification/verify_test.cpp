// artcal verify and artcal points as a laboratory uses them.
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "artefacts/artefact/artefact_file.h"
#include "tests/end_to_end/program.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using Json = nlohmann::json;
using ::testing::Contains;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::replaced;

class Verify : public testing::ProgramTest {
 protected:
  Json json_of(const std::vector<std::string>& command, int exit_code) {
    const Ended ended = run(command);
    EXPECT_EQ(ended.exit_code, exit_code) << ended.err << ended.out.substr(0, 2000);
    return ended.out.empty() ? Json() : Json::parse(ended.out);
  }
};

TEST_F(Verify, TheIdentifiedArmConformsAndTheNominalOneDoesNot) {
  take("ball-bar");
  take("iso10360-12");
  ASSERT_EQ(run({"identify", "ball-bar/recording.toml", "-o", "arm.toml", "--quiet"}).exit_code, 0);
  const std::vector<std::string> verify{"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12", "--json",
                                        "-"};
  const auto with_arm = [&](const std::string& arm) {
    auto command = verify;
    command.insert(command.end(), {"--arm", arm});
    return command;
  };
  const Json after = json_of(with_arm("arm.toml"), 0);
  EXPECT_EQ(after["conclusion"], "conformity_shown");
  EXPECT_EQ(after["values"].size(), 2u + 2u + 2u + 105u);
  EXPECT_THAT(after["missing"], IsEmpty());
  const Json before = json_of(with_arm("ball-bar/arm.toml"), 1);
  EXPECT_EQ(before["conclusion"], "non_conformity_shown");
  double worst = 0.0;
  for (const Json& value : before["values"]) {
    worst = std::max(worst, std::abs(value["value_mm"].get<double>()));
  }
  EXPECT_GT(worst, 1.0);
  // The example's own arm is that identification.
  EXPECT_NEAR(json_of(verify, 0)["values"][6]["value_mm"].get<double>(), after["values"][6]["value_mm"].get<double>(),
              1e-6);
}

// Whoever judges by the example's identification judges by readings that the arm was made to fit.
TEST_F(Verify, AnArmIsNotJudgedByTheReadingsThatItWasIdentifiedFrom) {
  take("ball-bar");
  take("iso10360-12");
  ASSERT_EQ(run({"identify", "ball-bar/recording.toml", "-o", "arm.toml", "--quiet", "--no-leave-out"}).exit_code, 0);
  // In the example each reading has a repeat of its own; a verification takes the readings of a ball together.
  std::istringstream example(text_of("ball-bar/readings.csv"));
  std::string together;
  for (std::string row; std::getline(example, row);) {
    std::size_t second = row.find(',', row.find(',') + 1), fourth = row.find(',', row.find(',', second + 1) + 1);
    together += row.substr(0, second) + row.substr(fourth) + "\n";
  }
  write("ball-bar/readings.csv", together);
  const std::string specification =
      "schema = \"artcal-specification/1\"\nunits = { length = \"mm\", limit = \"um\" }\n[[limit]]\nof = \"E_Uni\"\n"
      "B = 500\n[decision]\nrule = \"simple\"\n[plan]\n";
  write("ball-bar/specification.toml", specification);
  const std::vector<std::string> verify{"verify",          "ball-bar/recording.toml",
                                        "--standard",      "iso10360-12",
                                        "--arm",           "arm.toml",
                                        "--specification", "ball-bar/specification.toml",
                                        "--json",          "-"};
  EXPECT_THAT(json_of(verify, 1)["missing"].dump(), HasSubstr("[independent_readings]"));
  // A part of them in another file, another order and another unit, under another name.
  std::istringstream lines(text_of("ball-bar/readings.csv"));
  std::string header, line, some;
  std::getline(lines, header);
  for (int i = 0; std::getline(lines, line); ++i) {
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string one; std::getline(stream, one, ',');) fields.push_back(one);
    std::string row;
    for (std::size_t f = 0; f < fields.size(); ++f) {
      const bool joint = f + 6 >= fields.size();
      row += (f == 0 ? "" : ",") +
             (joint ? fmt::format("{:.12f}", std::stod(fields[f]) * 3.14159265358979323846 / 180.0) : fields[f]);
    }
    some = i % 7 == 0 ? some : row + "\n" + some;
  }
  write("ball-bar/readings.csv", header + "\n" + some);
  write("ball-bar/recording.toml",
        replaced(replaced(text_of("ball-bar/recording.toml"), "joint = \"deg\"", "joint = \"rad\""),
                 "simulated arm on a ball bar", "another name"));
  const Json by_some = json_of(verify, 1);
  EXPECT_EQ(by_some["conclusion"], "not_shown");
  EXPECT_THAT(by_some["missing"].dump(), HasSubstr("readings that it is judged by"));
  // Waived by name, and said.
  write("ball-bar/specification.toml", "waive = [\"independent_readings\", \"plausible_values\"]\n" + specification);
  const Json waived = json_of(verify, 1);  // what else is missing goes on being so
  EXPECT_EQ(waived["waived"].size(), 1u) << waived["waived"].dump();
  EXPECT_THAT(waived["missing"].dump(), ::testing::Not(HasSubstr("[independent_readings]")));
}

// The first 15 of each ball's 25 points and of each five, once and pasted again: a test of too few points stays one.
TEST_F(Verify, RowsThatAreThereTwiceCountOnce) {
  take("iso10360-12");
  const std::vector<std::string> verify{"verify", "iso10360-12/recording.toml", "--json", "-"};
  std::istringstream lines(text_of("iso10360-12/readings.csv"));
  std::string line, some, again;
  std::getline(lines, line);
  const std::string header = line + "\n";
  for (int ball = 0; std::getline(lines, line);) {
    const bool is_pattern = line.starts_with("ball,ball 1,ball,,");
    ball += is_pattern ? 1 : 0;
    if (!is_pattern || ball <= 15) some += line + "\n";
    if (is_pattern && ball <= 10) again += line + "\n";
  }
  write("iso10360-12/readings.csv", header + some);
  const Json once = json_of(verify, 1);
  EXPECT_THAT(once["missing"].dump(), HasSubstr("15 of 25 points"));
  write("iso10360-12/readings.csv", header + some + again);
  const Json pasted = json_of(verify, 1);
  EXPECT_EQ(pasted["readings"], once["readings"]);
  EXPECT_EQ(pasted["missing"], once["missing"]);
  EXPECT_THAT(pasted["warnings"].dump(), HasSubstr("10 of "));
  write("iso10360-12/recording.toml",
        replaced(text_of("iso10360-12/recording.toml"), "[\"readings.csv\"]", "[\"readings.csv\", \"readings.csv\"]"));
  const Ended twice = run({"verify", "iso10360-12/recording.toml"});
  EXPECT_EQ(twice.exit_code, 3);
  EXPECT_THAT(twice.err, HasSubstr("names the table \"readings.csv\" twice"));
}

TEST_F(Verify, ACertificateThatLapsedTheDayBeforeShowsNothing) {
  take("iso10360-12");
  write("iso10360-12/recording.toml",
        replaced(text_of("iso10360-12/recording.toml"), "date = 2026-03-10", "date = 2028-03-02"));
  const Ended lapsed = run({"verify", "iso10360-12/recording.toml"});
  EXPECT_EQ(lapsed.exit_code, 1);
  EXPECT_THAT(lapsed.out, HasSubstr("CONFORMITY NOT SHOWN"));
  EXPECT_THAT(lapsed.out, HasSubstr("had lapsed: it was valid until 2028-03-01, the readings are of 2028-03-02 "
                                    "[certificate_lapsed]"));
  write("iso10360-12/specification.toml", replaced(text_of("iso10360-12/specification.toml"), "measuring_range",
                                                   "waive = [\"certificate_lapsed\"]\nmeasuring_range"));
  const Ended waived = run({"verify", "iso10360-12/recording.toml"});
  EXPECT_EQ(waived.exit_code, 0) << waived.out.substr(0, 2000);
  EXPECT_THAT(waived.out, HasSubstr("Waived by the specification:"));
}

// What warnings, missing evidence and findings have in common is said once.
TEST_F(Verify, WhatIsWrongWithTheInputIsSaidOnce) {
  take("iso10360-12");
  write("iso10360-12/recording.toml",
        replaced(text_of("iso10360-12/recording.toml"), "date = 2026-03-10", "date = 2028-03-02"));
  const std::string readings = text_of("iso10360-12/readings.csv");
  const std::size_t first = readings.find('\n') + 1;
  write("iso10360-12/readings.csv", readings + readings.substr(first, readings.find('\n', first) + 1 - first));
  const Ended ended = run({"verify", "iso10360-12/recording.toml"});
  const auto count = [&](const std::string& text) {
    int found = 0;
    for (auto at = ended.out.find(text); at != std::string::npos; at = ended.out.find(text, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("repeat an earlier one in every number"), 1) << ended.out;
  EXPECT_EQ(count("had lapsed: it was valid until"), 2) << "the ball's and the bar's";
  EXPECT_EQ(count("Findings:"), 0);
}

// What cannot be stands before the verdict that rests on it.
TEST_F(Verify, ALimitInTheWrongUnitIsSaidBeforeTheVerdict) {
  take("iso10360-12");
  write("iso10360-12/specification.toml", replaced(text_of("iso10360-12/specification.toml"), "B = 30", "B = 7400"));
  const Ended ended = run({"verify", "iso10360-12/recording.toml"});
  EXPECT_EQ(ended.exit_code, 1);
  const auto said = ended.out.find("the limit of P_Size is 7.4 mm");
  EXPECT_LT(said, ended.out.find("CONFORMITY NOT SHOWN"));
}

// The radius is identified with the arm; the recording that it is judged by names the nominal one.
TEST_F(Verify, AnIdentifiedRadiusIsUsed) {
  take("ball-bar");
  take("iso10360-12");
  write("ball-bar/arm.toml", replaced(text_of("ball-bar/arm.toml"), "radius = 3", "radius = 2.99"));
  ASSERT_EQ(
      run({"identify", "ball-bar/recording.toml", "-o", "arm.toml", "--free", "radius", "--quiet", "--no-leave-out"})
          .exit_code,
      0);
  const Json values =
      json_of({"verify", "iso10360-12/recording.toml", "--arm", "arm.toml", "--json", "-"}, 0)["values"];
  // 10 um of the nominal radius would be 20 um of each diameter.
  for (const Json& value : values) {
    if (value["quantity"] == "P_Size") {
      EXPECT_LT(std::abs(value["value_mm"].get<double>()), 0.018);
    }
  }
  EXPECT_EQ(run({"points", "iso10360-12/recording.toml", "--arm", "arm.toml", "-o", "points.csv"}).exit_code, 0);
}

TEST_F(Verify, ABumpedArmIsFound) {
  take("iso10360-12");
  const Ended ended = run(
      {"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12", "--arm", "iso10360-12/bumped-arm.toml"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.out, HasSubstr("NON-CONFORMITY PROVEN"));
  EXPECT_THAT(ended.out, HasSubstr("non-conformity proven"));
}

TEST_F(Verify, AFailedTestEndsWithItsVerdict) {
  take("iso10360-12");
  for (const bool all : {false, true}) {
    std::vector<std::string> command{"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12",
                                     "--arm",  "iso10360-12/bumped-arm.toml"};
    if (all) {
      command.push_back("--all");
    }
    const std::string out = run(command).out;
    const std::size_t last = out.rfind('\n', out.size() - 2) + 1;
    EXPECT_THAT(out.substr(last), ::testing::MatchesRegex("ISO 10360-12:2016: NON-CONFORMITY PROVEN "
                                                          "\\(non-conformity in [0-9]+ of 111 values[^\n]*\\)\n"));
  }
  EXPECT_THAT(run({"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12"}).out,
              HasSubstr("octants are counted about the shoulder"));
}

TEST_F(Verify, ThePrintedLengthsAreTheWorstDozenAndWhateverDoesNotConform) {
  take("iso10360-12");
  const std::vector<std::string> verify{"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), verify.begin(), verify.end());
    return run(more);
  };
  // Lines of the table of lengths, by the word before a verdict's place.
  const auto lines = [](const std::string& text, const std::string& word) {
    std::istringstream stream(text.substr(text.rfind("certified, mm")));
    int found = 0;
    for (std::string line; std::getline(stream, line);) found += line.find(word) != std::string::npos ? 1 : 0;
    return found;
  };
  const Ended good = with({});
  EXPECT_EQ(lines(good.out, "% of reach"), 12);
  EXPECT_THAT(good.out, HasSubstr("and 93 more: --all shows them, --json has them"));
  EXPECT_EQ(lines(with({"--all"}).out, "% of reach"), 105);
  const Json values =
      json_of({"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12", "--json", "-"}, 0)["values"];
  double worst = 0.0;
  for (const Json& value : values) {
    worst = value["quantity"] == "E_Uni" ? std::max(worst, std::abs(value["value_mm"].get<double>())) : worst;
  }
  EXPECT_THAT(good.out.substr(good.out.rfind("certified, mm")), HasSubstr(fmt::format("{:.1f}", 1000.0 * worst)));
  take("ball-bar");
  const Ended nominal = with({"--arm", "ball-bar/arm.toml"});
  const int all_bad = lines(with({"--arm", "ball-bar/arm.toml", "--all"}).out, "non-conformity proven");
  EXPECT_GT(all_bad, 12);
  EXPECT_EQ(lines(nominal.out, "non-conformity proven"), all_bad);
}

TEST_F(Verify, ThePlantedBallOfTheSpherePlateIsNamed) {
  take("sphere-plate");
  const Ended ended = run({"verify", "sphere-plate/recording.toml", "--standard", "sphere-plate"});
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("coordinates as the arm's own software reported them"));
  EXPECT_THAT(ended.out, HasSubstr("placement \"1\": ball \"C4\" is off by"));
  EXPECT_THAT(ended.out, HasSubstr("placement \"2\": ball \"C4\" is off by"));
  EXPECT_THAT(ended.err, IsEmpty());
}

// The example's first placement, turned about the base's z axis by quarters: four placements without an arm's errors.
TEST_F(Verify, ASwungRoundPlateIsWrittenAndServesAsAnArtefact) {
  take("sphere-plate");
  std::istringstream lines(text_of("sphere-plate/readings.csv"));
  std::string line, text;
  std::getline(lines, line);
  text = line + "\n";
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::vector<std::string> field;
    for (std::string one; std::getline(fields, one, ',');) field.push_back(one);
    ASSERT_EQ(field.size(), 6u);
    if (field[0] != "1") continue;
    double x = std::stod(field[3]), y = std::stod(field[4]);
    for (int turn = 1; turn <= 4; ++turn) {
      text += fmt::format("{},{},{},{},{},{}\n", turn, field[1], field[2], x, y, field[5]);
      x = std::exchange(y, x);
      x = -x;
    }
  }
  write("sphere-plate/readings.csv", text);
  const std::vector<std::string> verify{"verify", "sphere-plate/recording.toml", "--standard", "sphere-plate"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), verify.begin(), verify.end());
    return run(more);
  };
  const Ended found = with({"--artefact-out", "found.toml", "--json", "found.json"});
  EXPECT_EQ(found.exit_code, 1) << found.err;
  EXPECT_THAT(found.out, HasSubstr("ball \"C4\" is off by"));
  const Json calibration = Json::parse(text_of("found.json"))["plate_calibrations"][0];
  const auto artefact = read_artefact_file(file("found.toml"));
  ASSERT_TRUE(artefact) << artefact.error().text();
  ASSERT_EQ(artefact->artefact.features.size(), 25u);
  for (std::size_t i = 0; i < 25; ++i) {
    const CertifiedFeature& ball = artefact->artefact.features[i];
    EXPECT_EQ(ball.name, calibration["balls"][i]["feature"]);
    EXPECT_EQ(ball.at->x(), calibration["balls"][i]["at_mm"][0].get<double>());
    EXPECT_EQ(ball.u_at, calibration["balls"][i]["u_mm"].get<double>());
  }
  write("sphere-plate/plate.toml", text_of("found.toml"));
  EXPECT_THAT(with({}).out, Not(HasSubstr("C4\" is off by")));
  // Nothing to write: two placements, or no plate at all.
  take("iso10360-12");
  const Ended none = run({"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12", "--artefact-out", "x"});
  EXPECT_EQ(none.exit_code, 4);
  EXPECT_THAT(none.err, HasSubstr("four or more placements, and there are 0"));
  EXPECT_EQ(with({"--artefact-out", "sphere-plate/plate.toml"}).exit_code, 2);
}

TEST_F(Verify, CoordinatesAloneIdentifyNoArm) {
  take("sphere-plate");
  for (const char* command : {"identify", "coupling", "points"}) {
    const Ended ended = run({command, "sphere-plate/recording.toml"});
    EXPECT_EQ(ended.exit_code, 3) << command;
    EXPECT_THAT(ended.err, HasSubstr("readings.csv:2: the reading has coordinates but no joint angles")) << command;
  }
}

TEST_F(Verify, AnInterimCheckFindsADriftAndNothingWhereThereIsNone) {
  take("iso10360-12");
  const std::vector<std::string> verify{"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12"};
  auto first = verify;
  first.insert(first.end(), {"--json", "then.json", "--quiet"});
  ASSERT_EQ(run(first).exit_code, 0);
  auto again = verify;
  again.insert(again.end(), {"--against", "then.json"});
  const Ended same = run(again);
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("NO SIGNIFICANT DRIFT"));
  again.insert(again.end(), {"--arm", "iso10360-12/bumped-arm.toml"});
  const Ended bumped = run(again);
  EXPECT_EQ(bumped.exit_code, 1);
  EXPECT_THAT(bumped.out, HasSubstr("Interim check: SIGNIFICANT DRIFT"));
}

TEST_F(Verify, AnEarlierResultThatIsNoneIsRefused) {
  take("iso10360-12");
  for (const char* text : {"{}", "[]", "{\"kind\": \"verification\"}", "no json", "[[[[[["}) {
    write("then.json", text);
    const Ended ended =
        run({"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12", "--against", "then.json"});
    EXPECT_EQ(ended.exit_code, 3) << text;
    EXPECT_THAT(ended.err, HasSubstr("then.json: this is no result of artcal verify")) << text;
  }
}

TEST_F(Verify, PointsAreAReadingsFileOfCoordinates) {
  take("iso10360-12");
  ASSERT_EQ(run({"points", "iso10360-12/recording.toml", "-o", "points.csv"}).exit_code, 0);
  write("recording.toml",
        "schema = \"artcal-recording/1\"\nartefacts = [\"iso10360-12/ball.toml\", \"iso10360-12/bar.toml\"]\n"
        "readings = [\"points.csv\"]\nspecification = \"iso10360-12/specification.toml\"\n"
        "date = 2026-03-10\nunits = { length = \"mm\" }\n[[probe]]\nname = \"ball 6 mm\"\nradius = 3\n");
  const Json by_points = json_of({"verify", "recording.toml", "--standard", "iso10360-12", "--json", "-"}, 0);
  const Json by_joints =
      json_of({"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12", "--json", "-"}, 0);
  EXPECT_EQ(by_points["tip_centres"], "reported");
  ASSERT_EQ(by_points["values"].size(), by_joints["values"].size());
  for (std::size_t i = 0; i < by_points["values"].size(); ++i) {
    EXPECT_EQ(by_points["values"][i]["value_mm"], by_joints["values"][i]["value_mm"]);
  }
}

TEST_F(Verify, WrongCallsAreRefused) {
  take("iso10360-12");
  take("ball-bar");
  const Ended no_standard = run({"verify", "ball-bar/recording.toml"});
  EXPECT_EQ(no_standard.exit_code, 2);
  EXPECT_THAT(no_standard.err, HasSubstr("what is the arm to be judged by?"));
  EXPECT_EQ(run({"verify", "iso10360-12/recording.toml"}).exit_code, 0) << "the recording says what by";
  EXPECT_EQ(run({"verify", "iso10360-12/recording.toml", "--standard", "iso10360-2"}).exit_code, 2);
  EXPECT_EQ(run({"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12", "--json",
                 "iso10360-12/specification.toml"})
                .exit_code,
            2);
  write("arm.toml", replaced(text_of("iso10360-12/arm.toml"), "radius = 3.0", "radius = 2.0"));
  const Ended other_tip =
      run({"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12", "--arm", "arm.toml"});
  EXPECT_EQ(other_tip.exit_code, 3);
  EXPECT_THAT(other_tip.err, HasSubstr("one of them is wrong"));
}

}  // namespace
}  // namespace artcal
