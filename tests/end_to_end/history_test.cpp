// What laboratories ask of a store about one arm, or one certificate.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/archive.h"

namespace artcal {
namespace {

using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

class History : public testing::ArchiveTest {
 protected:
  void SetUp() override {
    const auto test = [&](const std::string& name, const std::string& date, const std::string& number) {
      file_away("iso10360-12", name, "date = " + date + "\n");
      write("archive/" + name + "/bar.toml", text_of("archive/" + name + "/bar.toml") + "\n[certificate]\nnumber = \"" +
                                                 number + "\"\nlaboratory = \"Example Laboratory\"\n");
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
  EXPECT_THAT(ended.out, HasSubstr("iso10360-12 from 2026-03-01 to 2026-06-01: no significant change of"));
  EXPECT_THAT(ended.out, HasSubstr("iso10360-12 from 2026-06-01 to 2026-09-01: "));
  EXPECT_THAT(ended.out, HasSubstr(" values CHANGED"));
  const Json json = Json::parse(run({"history", arm_, "--store", "s.sqlite", "--json", "-"}).out);
  EXPECT_EQ(json["verifications"].size(), 3u);
  EXPECT_EQ(json["verifications"][2]["conclusion"], "non_conformity_shown");
  ASSERT_EQ(json["value_steps"].size(), 2u);
  EXPECT_EQ(json["value_steps"][0]["certificates_in_common"].size(), 2u) << "the ball, and 4711";
  EXPECT_EQ(json["value_steps"][1]["certificates_in_common"].size(), 1u) << "the ball";
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

TEST_F(History, WrongCallsAreRefused) {
  const Ended unknown = run({"history", "arm 99", "--store", "s.sqlite"});
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_THAT(unknown.err, HasSubstr("\"Franka Emika Panda\""));
  EXPECT_EQ(run({"history", "--store", "s.sqlite"}).exit_code, 2);
  EXPECT_EQ(run({"history", "arm", "--certificate", "1", "--store", "s.sqlite"}).exit_code, 2);
  EXPECT_EQ(run({"history", "--certificate", "4711", "--json", "-", "--store", "s.sqlite"}).exit_code, 2);
  EXPECT_EQ(run({"history", "arm", "--store", "gone.sqlite"}).exit_code, 3);
}

}  // namespace
}  // namespace artcal
