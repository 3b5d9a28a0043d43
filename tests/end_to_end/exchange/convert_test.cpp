// artcal convert: tables of results as CSV, read here as RFC 4180 has it and held against the JSON.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using ::testing::Contains;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Json = nlohmann::ordered_json;

using Row = std::map<std::string, std::string>;

std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row;
  std::string field;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c != '"') {
        field += c;
      } else if (i + 1 < text.size() && text[i + 1] == '"') {
        field += text[++i];
      } else {
        quoted = false;
      }
    } else if (c == '"') {
      quoted = true;
    } else if (c == ',' || c == '\n') {
      row.push_back(field);
      field.clear();
      if (c == '\n') {
        rows.push_back(row);
        row.clear();
      }
    } else {
      field += c;
    }
  }
  return rows;
}

class Convert : public testing::ProgramTest {
 protected:
  [[nodiscard]] std::vector<Row> table(const std::string& result, const std::string& part) const {
    const Ended ended = run({"convert", result, "--csv", "--part", part});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const auto lines = parse_csv(ended.out);
    std::vector<Row> rows;
    for (std::size_t i = 1; i < lines.size(); ++i) {
      EXPECT_EQ(lines[i].size(), lines[0].size());
      Row& row = rows.emplace_back();
      for (std::size_t k = 0; k < lines[i].size(); ++k) {
        row[lines[0][k]] = lines[i][k];
      }
    }
    return rows;
  }
};

TEST_F(Convert, AnIdentificationGivesParametersReadingsAndLengths) {
  take("ball-bar");
  ASSERT_EQ(run({"identify", "ball-bar/recording.toml", "--json", "r.json", "--no-leave-out", "-q"}).exit_code, 0);
  const Json json = Json::parse(text_of("r.json"));
  const auto parameters = table("r.json", "parameters");
  ASSERT_EQ(parameters.size(), json["parameters"].size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    EXPECT_EQ(parameters[i].at("name"), json["parameters"][i]["name"]);
    EXPECT_EQ(std::stod(parameters[i].at("identified")), json["parameters"][i]["identified"].get<double>());
  }
  const auto readings = table("r.json", "readings");
  ASSERT_EQ(readings.size(), 700u);
  EXPECT_EQ(std::stod(readings[17].at("after_mm")), json["residuals"]["after_mm"][17].get<double>());
  EXPECT_EQ(std::stod(readings[17].at("tip_mm.2")), json["residuals"]["tip_mm"][1][17].get<double>());
  EXPECT_EQ(std::stod(readings[17].at("joints_rad.6")), json["residuals"]["joints_rad"][5][17].get<double>());
  const auto feature = json["after"]["features"][json["residuals"]["feature"][17].get<std::size_t>()];
  EXPECT_EQ(readings[17].at("feature"), feature["feature"]);
  EXPECT_EQ(readings[17].at("placement"), feature["placement"]);
  EXPECT_EQ(table("r.json", "lengths").size(), json["after"]["lengths"].size());
  EXPECT_EQ(run({"convert", "r.json", "--csv"}).out, run({"convert", "r.json", "--csv", "--part", "parameters"}).out);
  EXPECT_EQ(run({"convert", "r.json", "--csv", "-o", "p.csv"}).exit_code, 0);
  EXPECT_EQ(text_of("p.csv"), run({"convert", "r.json", "--csv"}).out);
}

TEST_F(Convert, AVerificationGivesVerdicts) {
  take("iso10360-12");
  (void)run({"verify", "iso10360-12/recording.toml", "--json", "v.json", "-q"});
  const Json json = Json::parse(text_of("v.json"));
  const auto verdicts = table("v.json", "verdicts");
  ASSERT_EQ(verdicts.size(), json["values"].size());
  EXPECT_EQ(verdicts[3].at("verdict"), json["values"][3]["verdict"]);
  EXPECT_EQ(std::stod(verdicts[3].at("budget.points_mm")), json["values"][3]["budget"]["points_mm"].get<double>());
  EXPECT_THAT(verdicts[0].at("second"), IsEmpty()) << "null is empty";
}

TEST_F(Convert, NamesKeepWhatSeparatesFields) {
  write("r.json", R"({"schema_version": 2, "kind": "fit",
                      "values": [{"name": "a, \"b\"\nc", "value": 0.1}, {"unit": "mm"}]})");
  const auto rows = table("r.json", "values");
  EXPECT_EQ(rows[0].at("name"), "a, \"b\"\nc");
  EXPECT_EQ(rows[1].at("name"), "");
  EXPECT_EQ(rows[1].at("unit"), "mm");
}

// A later version may write more; what this one knows must be what it is.
TEST_F(Convert, AFieldThatThisVersionDoesNotKnowIsAColumn) {
  write("r.json", R"({"schema_version": 2, "kind": "identification",
                      "parameters": [{"name": "a1", "unit": "mm", "nominal": 1, "identified": 1.5, "state": "identified",
                                      "standard_uncertainty": 0.1, "later": 7}]})");
  EXPECT_EQ(table("r.json", "parameters")[0].at("later"), "7");
}

TEST_F(Convert, ADamagedTableIsRefusedByThePlaceOfTheDamage) {
  const auto refusal = [&](const std::string& text, const std::string& part) {
    write("r.json", text);
    const Ended ended = run({"convert", "r.json", "--csv", "--part", part});
    EXPECT_EQ(ended.exit_code, 3);
    return ended.err;
  };
  EXPECT_THAT(refusal(R"({"schema_version": 2, "kind": "identification", "parameters": [{"name": "a1", "unit": 3}]})",
                      "parameters"),
              HasSubstr("r.json: the result is not as --json wrote it: parameters[0].unit is 3, expected a text"));
  EXPECT_THAT(refusal(R"({"schema_version": 2, "kind": "identification",
                          "residuals": {"reading": [0], "feature": [0], "after_mm": 3},
                          "after": {"features": [1]}})",
                      "readings"),
              HasSubstr("after.features[0] is 1, expected an object"));
}

TEST_F(Convert, WhatIsNotThereIsRefused) {
  write("r.json", R"({"schema_version": 2, "kind": "identification", "parameters": [{"name": "a1"}]})");
  const Ended readings = run({"convert", "r.json", "--csv", "--part", "readings"});
  EXPECT_EQ(readings.exit_code, 3);
  EXPECT_THAT(readings.err,
              HasSubstr("r.json: the result has no \"readings\", but parameters; identify --no-residuals"));
  EXPECT_EQ(run({"convert", "r.json"}).exit_code, 2);
  EXPECT_EQ(run({"convert", "r.json", "--csv", "-o", "r.json"}).exit_code, 2) << "the result would be overwritten";
  write("other.json", "{}");
  EXPECT_THAT(run({"convert", "other.json", "--csv"}).err, HasSubstr("this is no result of artcal"));
}

}  // namespace
}  // namespace artcal
