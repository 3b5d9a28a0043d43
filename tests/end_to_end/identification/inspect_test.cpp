// artcal inspect, and what identify makes of the same mistakes.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::AllOf;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;

class Inspect : public testing::ProgramTest {
 protected:
  void replace(const std::string& name, const std::string& old, const std::string& now) const {
    std::string text = text_of(name);
    const auto at = text.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    write(name, text.replace(at, old.size(), now));
  }
  std::string kinds(const std::string& recording) {
    const Ended ended = run({"inspect", recording, "--json", "-"});
    std::string text;
    const Json result = Json::parse(ended.out);
    for (const Json& finding : result["findings"]) text += finding["kind"].get<std::string>() + " ";
    EXPECT_EQ(ended.exit_code, text.empty() ? 0 : 1) << ended.err;
    return text;
  }
};

TEST_F(Inspect, FindsNothingInTheExamples) {
  for (const char* example : {"ball-bar", "gao2013", "iso10360-12", "sphere-plate", "two-socket-bar"}) {
    take(example);
    EXPECT_EQ(kinds(std::string(example) + "/recording.toml"), "") << example;
  }
}

TEST_F(Inspect, NamesTheTipsDiameterGivenAsItsRadius) {
  take("ball-bar");
  replace("ball-bar/arm.toml", "radius = 3", "radius = 6");
  const Ended ended = run({"identify", "ball-bar/recording.toml"});
  EXPECT_EQ(ended.exit_code, 4);
  EXPECT_THAT(ended.err,
              AllOf(HasSubstr("with a radius of 3 mm"), HasSubstr("diameter"), Not(HasSubstr("iterations"))));
}

// Without a stated noise, 0.3 mm is less than what the check of residuals refuses.
TEST_F(Inspect, AFitThatAMistakeExplainsFarBetterIsFour) {
  take("ball-bar");
  replace("ball-bar/arm.toml", "radius = 3", "radius = 0");
  std::string recording = text_of("ball-bar/recording.toml");
  recording.resize(recording.find("[noise]"));
  write("ball-bar/recording.toml", recording);
  const Ended ended = run({"identify", "ball-bar/recording.toml", "--no-leave-out"});
  EXPECT_EQ(ended.exit_code, 4);
  EXPECT_THAT(ended.err, HasSubstr("seems forgotten"));
}

TEST_F(Inspect, NamesColumnsThatAreExchanged) {
  take("ball-bar");
  replace("ball-bar/readings.csv", "q1,q2,q3", "q1,q3,q2");
  const Ended ended = run({"identify", "ball-bar/recording.toml"});
  EXPECT_EQ(ended.exit_code, 4);
  EXPECT_THAT(ended.err, AllOf(HasSubstr("q2 and q3 exchanged"), Not(HasSubstr("iterations"))));
}

// Two mistakes at once: both are named, no third, and the exit code is that of a gross misfit.
TEST_F(Inspect, NamesASecondMistakeBehindTheFirst) {
  take("ball-bar");
  replace("ball-bar/readings.csv", "q1,q2,q3", "q1,q3,q2");
  replace("ball-bar/arm.toml", "radius = 3", "radius = 0");
  EXPECT_EQ(kinds("ball-bar/recording.toml"), "joints_exchanged tip_radius ");
  const Ended ended = run({"identify", "ball-bar/recording.toml", "--no-leave-out"});
  EXPECT_EQ(ended.exit_code, 4);
  EXPECT_THAT(ended.err, AllOf(HasSubstr("q2 and q3 exchanged"), HasSubstr("Then: with a radius of 2.99")));
}

TEST_F(Inspect, NamesAWholeFileInAnotherUnit) {
  take("ball-bar");
  replace("ball-bar/bar.toml", "length = \"mm\"", "length = \"in\"");
  EXPECT_EQ(kinds("ball-bar/recording.toml"), "length_unit ");
}

TEST_F(Inspect, NamesPositionsGivenAsSteps) {
  take("ball-bar");
  std::string bar = text_of("ball-bar/bar.toml");
  bar.resize(bar.find("[[distance]]"));
  write("ball-bar/bar.toml", bar +
                                 "[[distance]]\nalong = [\"0\", \"1\", \"2\", \"3\"]\n"
                                 "steps = [250.0123, 600.0045, 1000.0078]\nU = 0.0008\nk = 2\n");
  EXPECT_THAT(run({"inspect", "ball-bar/recording.toml"}).out,
              AllOf(HasSubstr("1850.025 mm from \"0\" to \"3\""), HasSubstr("1000.008 mm")));
}

TEST_F(Inspect, NamesRowsThatAreThereTwice) {
  take("ball-bar");
  const std::string readings = text_of("ball-bar/readings.csv");
  write("ball-bar/readings.csv", readings + readings.substr(readings.find('\n') + 1));
  EXPECT_EQ(kinds("ball-bar/recording.toml"), "repeated_readings ");
}

TEST_F(Inspect, NamesALimitInAnotherUnit) {
  take("iso10360-12");
  replace("iso10360-12/specification.toml", "limit = \"um\"", "limit = \"mm\"");
  EXPECT_THAT(kinds("iso10360-12/recording.toml"), HasSubstr("implausible_value"));
}

}  // namespace
}  // namespace artcal
