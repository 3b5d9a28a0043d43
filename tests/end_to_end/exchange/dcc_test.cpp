// Certificates from end to end: what an artefact's says reaches the result, and the result becomes one.
#include <algorithm>
#include <cstdlib>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "artefacts/dcc/dcc_read.h"
#include "artefacts/dcc/dcc_select.h"
#include "tests/end_to_end/program.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

// The file that docs/files.md shows.
std::string data_file() {
  std::istringstream lines(testing::read_all(std::string(ARTCAL_SOURCE_DIR) + "/docs/files.md"));
  std::string block;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("    schema = \"artcal-dcc-data/1\"") || (!block.empty() && line.starts_with("    "))) {
      block += line.substr(4) + "\n";
    } else if (!block.empty() && !line.empty()) {
      break;
    }
  }
  return block;
}

class Certificates : public testing::ProgramTest {
 protected:
  Certificates() {
    take("ball-bar");
    write("data.toml", data_file());
  }
  // The bar with such a certificate, read on such a day.
  void certify(const std::string& certificate, const std::string& day) const {
    write("ball-bar/bar.toml", "certificate = { " + certificate + " }\n" + text_of("ball-bar/bar.toml"));
    write("ball-bar/recording.toml", "date = " + day + "\n" + text_of("ball-bar/recording.toml"));
  }
  // Under the schemas of DCC 3.3.0 and D-SI 2.2.1.
  [[nodiscard]] bool is_valid(const std::string& name) const {
    const std::string schemas = std::string(ARTCAL_SOURCE_DIR) + "/tests/reference/dcc/schema-3.3.0";
    const std::string command = "cd '" + schemas +
                                "' && XML_CATALOG_FILES=catalog.xml xmllint --nonet --noout --schema dcc.xsd '" +
                                file(name).string() + "' 2>&1";
    return std::system(command.c_str()) == 0;
  }
  [[nodiscard]] testing::Ended verify(const std::string& standard, const std::vector<std::string>& more) const {
    const std::string example = standard == "b89.4.22" ? "iso10360-12" : standard;
    std::vector<std::string> all{"verify",     example + "/recording.toml",
                                 "--standard", standard,
                                 "-q",         "--json",
                                 "v.json",     "--dcc",
                                 "v.xml",      "--dcc-data",
                                 "data.toml"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
  [[nodiscard]] testing::Ended identify(const std::vector<std::string>& more) const {
    std::vector<std::string> all{"identify", "ball-bar/recording.toml", "--no-leave-out"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
};

TEST_F(Certificates, ALapsedOneIsWarnedOfInTextJsonAndCertificate) {
  certify("number = \"4711 <b>\", laboratory = \"L\", valid_until = 2026-03-09", "2026-03-10");
  const testing::Ended ended = identify({"--json", "r.json", "--dcc", "out.xml", "--dcc-data", "data.toml"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr(", certificate 4711 <b> of L, valid until 2026-03-09\n"),
                               HasSubstr("Warning: the certificate \"4711 <b>\" of the artefact")));
  const Json result = Json::parse(text_of("r.json"));
  EXPECT_EQ(result["date"], "2026-03-10");
  EXPECT_EQ(result["artefacts"][0]["certificate"]["number"], "4711 <b>");
  EXPECT_EQ(result["artefacts"][0]["certificate"]["date"], nullptr);
  EXPECT_THAT(result["warnings"], ElementsAre(HasSubstr("had lapsed: it was valid until 2026-03-09")));
  EXPECT_THAT(text_of("out.xml"),
              AllOf(HasSubstr("Warning: the certificate \"4711 &lt;b&gt;\""), Not(HasSubstr("<b>"))));
}

TEST_F(Certificates, AnIdentifiedArmBecomesOneThatIsValidAndSaysTheSame) {
  const testing::Ended ended = identify({"-q", "--json", "r.json", "--dcc", "out.xml", "--dcc-data", "data.toml"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(is_valid("out.xml"));
  const auto certificate = read_dcc_file(file("out.xml"));
  ASSERT_TRUE(certificate) << certificate.error().text();
  EXPECT_EQ(certificate->certificate.number, "K-2026-017");
  int identified = 0;
  const Json result = Json::parse(text_of("r.json"));
  for (const Json& parameter : result["parameters"]) {
    const auto quantity = find_quantity(*certificate, parameter["name"].get<std::string>());
    ASSERT_TRUE(quantity) << quantity.error().text();
    EXPECT_EQ(quantity->numbers().values.at(0), parameter["identified"].get<double>());
    EXPECT_EQ(quantity->numbers().units.at(0), parameter["unit"] == "mm" ? "\\milli\\metre" : "\\radian");
    EXPECT_EQ(quantity->numbers().uncertainties.empty(), parameter["state"] != "identified");
    if (parameter["state"] == "identified") {
      EXPECT_EQ(quantity->numbers().uncertainties.at(0).U, 2.0 * parameter["standard_uncertainty"].get<double>());
      EXPECT_EQ(quantity->numbers().uncertainties.at(0).k, 2.0);
      ++identified;
    }
  }
  EXPECT_EQ(identified, 21);
}

TEST_F(Certificates, AVerificationBecomesOneThatIsValidAndSaysTheSame) {
  take("iso10360-12");
  ASSERT_EQ(verify("iso10360-12", {"--arm", "iso10360-12/bumped-arm.toml"}).exit_code, 1);
  EXPECT_TRUE(is_valid("v.xml"));
  const auto certificate = read_dcc_file(file("v.xml"));
  ASSERT_TRUE(certificate) << certificate.error().text();
  const Json result = Json::parse(text_of("v.json"));
  ASSERT_EQ(certificate->quantities.size(), result["values"].size());
  for (const Json& value : result["values"]) {
    const std::string second = value["second"].is_null() ? "" : " - " + value["second"].get<std::string>();
    const std::string repeat = value["repeat"] == "" ? "" : ", repeat " + value["repeat"].get<std::string>();
    const auto quantity =
        find_quantity(*certificate, value["quantity"].get<std::string>() + " " + value["first"].get<std::string>() +
                                        second + ", placement " + value["placement"].get<std::string>() + repeat);
    ASSERT_TRUE(quantity) << quantity.error().text();
    EXPECT_EQ(quantity->numbers().values.at(0), value["value_mm"].get<double>());
    EXPECT_EQ(quantity->numbers().uncertainties.at(0).U, 2.0 * value["u_mm"].get<double>());
    EXPECT_EQ(quantity->numbers().uncertainties.at(0).k, 2.0);
  }
  const std::string text = text_of("v.xml");
  const auto count = [&](const std::string& what) {
    int found = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  const auto verdicts = [&](const std::string& verdict) {
    return std::count_if(result["values"].begin(), result["values"].end(),
                         [&](const Json& value) { return value["verdict"] == verdict; });
  };
  EXPECT_GT(verdicts("does_not_conform"), 0);
  EXPECT_EQ(count("<dcc:conformity>pass<"), verdicts("conforms"));
  EXPECT_EQ(count("<dcc:conformity>fail<"), verdicts("does_not_conform"));
  EXPECT_EQ(count("<dcc:conformity>noPass<"), verdicts("nothing_proven"));
  EXPECT_THAT(text, AllOf(HasSubstr("non-conformity proven by iso10360-12"), HasSubstr("guard band 1.65 u")));
}

TEST_F(Certificates, PlatesAndIncompleteTestsBecomeValidOnes) {
  take("sphere-plate");
  take("iso10360-12");
  EXPECT_EQ(verify("sphere-plate", {}).exit_code, 1);
  EXPECT_TRUE(is_valid("v.xml"));
  EXPECT_THAT(text_of("v.xml"), AllOf(HasSubstr("C4, residual x"), HasSubstr("Warning: ")));
  EXPECT_EQ(verify("b89.4.22", {}).exit_code, 1);
  EXPECT_TRUE(is_valid("v.xml"));
  EXPECT_THAT(text_of("v.xml"), HasSubstr("Missing for a proof of conformity: "));
}

TEST_F(Certificates, AreRefusedWithoutWhatOnlyTheLaboratoryKnows) {
  EXPECT_EQ(identify({"--dcc", "out.xml"}).exit_code, 2);
  EXPECT_EQ(identify({"--dcc-data", "data.toml"}).exit_code, 2);
  write("data.toml", testing::replaced(data_file(), "serial_number = \"0017\"\n", ""));
  const testing::Ended ended = identify({"--dcc", "out.xml", "--dcc-data", "data.toml"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("`serial_number` is missing in [item]"));
  EXPECT_FALSE(std::filesystem::exists(file("out.xml")));
}

TEST_F(Certificates, AreRefusedForAnotherDay) {
  certify("number = \"1\"", "2026-03-09");
  const testing::Ended ended = identify({"--dcc", "out.xml", "--dcc-data", "data.toml"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err,
              HasSubstr("is for measurements from 2026-03-10 to 2026-03-11, but the recording is of 2026-03-09"));
}

TEST_F(Certificates, DoNotOverwriteWhatTheyRestOn) {
  EXPECT_EQ(identify({"--dcc", "data.toml", "--dcc-data", "data.toml"}).exit_code, 2);
  EXPECT_EQ(text_of("data.toml"), data_file());
}

}  // namespace
}  // namespace artcal
