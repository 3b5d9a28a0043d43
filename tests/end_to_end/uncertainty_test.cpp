// `artcal uncertainty`: what it takes, and what it refuses.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using testing::Ended;
using ::testing::HasSubstr;
using Json = nlohmann::json;

class UncertaintyCommand : public testing::ProgramTest {
 protected:
  void SetUp() override {
    take("ball-bar");
    ASSERT_EQ(run({"identify", "ball-bar/recording.toml", "-o", "arm.toml", "--no-leave-out"}).exit_code, 0);
  }
  Json result(std::vector<std::string> more) {
    more.insert(more.begin(), {"uncertainty", "arm.toml", "--json", "-", "--lengths", "20", "--rings", "2"});
    const Ended ended = run(more);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return Json::parse(ended.out);
  }
};

TEST_F(UncertaintyCommand, TakesTheNoiseThatIdentificationFound) {
  const Json found = result({});
  EXPECT_GT(found["probing_noise_mm"], 0.003);  // 3 µm of probing and 2" of each encoder make about 10 µm
  EXPECT_LT(found["probing_noise_mm"], 0.020);
  const Json doubled = result({"--probing-noise", "1 mm"});
  EXPECT_NEAR(doubled["lengths"][0]["u"]["rms_mm"], 1.41421, 1e-3);
  EXPECT_EQ(found["lengths"][0]["u_of_the_arm"], doubled["lengths"][0]["u_of_the_arm"]);
}

TEST_F(UncertaintyCommand, SaysTheSameEveryTime) {
  EXPECT_EQ(result({}), result({}));
  EXPECT_NE(result({}), result({"--seed", "2"}));
}

TEST_F(UncertaintyCommand, RefusesWhatItCannotKnow) {
  const Ended nominal = run({"uncertainty", "ball-bar/arm.toml"});
  EXPECT_EQ(nominal.exit_code, 3);
  EXPECT_THAT(nominal.err, HasSubstr("carries no covariance"));
  const Ended unit = run({"uncertainty", "arm.toml", "--encoder-noise", "2 um"});
  EXPECT_EQ(unit.exit_code, 2);
  EXPECT_THAT(unit.err, HasSubstr("expected a number with its unit"));
  const Ended probe = run({"uncertainty", "arm.toml", "--probe", "star"});
  EXPECT_EQ(probe.exit_code, 2);
  EXPECT_THAT(probe.err, HasSubstr("no probe \"star\""));
  std::string text = text_of("arm.toml");
  const auto first = text.find("  [", text.find("covariance = ["));
  text.insert(first + 3, "-");  // the first variance below zero
  write("broken.toml", text);
  const Ended broken = run({"uncertainty", "broken.toml"});
  EXPECT_EQ(broken.exit_code, 3);
  EXPECT_THAT(broken.err, HasSubstr("the covariance is none"));
}

}  // namespace
}  // namespace artcal
