// `artcal uncertainty`: what it takes, and what it refuses.
#include <csignal>
#include <map>

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
  EXPECT_NEAR(found["probing_noise_mm"].get<double>(), 0.003, 0.0003);  // as the recording states it, and enlarged
  const Json doubled = result({"--probing-noise", "1 mm"});
  EXPECT_NEAR(doubled["lengths"][0]["u"]["rms_mm"], 1.41421, 1e-3);
  EXPECT_EQ(found["lengths"][0]["u_of_the_arm"], doubled["lengths"][0]["u_of_the_arm"]);
}

// The arm's file keeps what the identification knew of the noise: both draw the same map.
TEST_F(UncertaintyCommand, OfTheArmsFileIsThatOfTheIdentificationsReport) {
  ASSERT_EQ(
      run({"identify", "ball-bar/recording.toml", "-o", "arm.toml", "--report", "identified.html", "--no-leave-out"})
          .exit_code,
      0);
  ASSERT_EQ(run({"uncertainty", "arm.toml", "--json", "map.json"}).exit_code, 0);
  const Json map = Json::parse(text_of("map.json"));
  EXPECT_NEAR(map["encoder_noise_rad"].get<double>(), 2.0 / 3600.0 * 3.14159265358979 / 180.0, 1e-6);
  EXPECT_NEAR(map["probing_noise_mm"].get<double>(), 0.003, 0.0003);
  ASSERT_EQ(run({"report", "map.json", "-o", "map.html"}).exit_code, 0);
  // The section of the arm's uncertainty is word for word that of the identification's report.
  const auto section = [&](const std::string& page) {
    const std::string text = text_of(page);
    const auto begin = text.find("What the identified arm measures like");
    return text.substr(begin, text.find("</table>", begin) - begin);
  };
  EXPECT_GT(section("map.html").size(), 500u);
  EXPECT_EQ(section("map.html"), section("identified.html"));
}

TEST_F(UncertaintyCommand, CountsAllParametersOfAModel) {
  const double chain = result({})["lengths"][2]["u_of_the_arm"]["rms_mm"];
  ASSERT_EQ(run({"identify", "ball-bar/recording.toml", "-o", "arm.toml", "--model", "dh+eccentricity+gain",
                 "--no-leave-out"})
                .exit_code,
            0);
  const double all = result({})["lengths"][2]["u_of_the_arm"]["rms_mm"];
  EXPECT_GT(all, 1.2 * chain);  // what more is asked of the same readings is told less well
  EXPECT_LT(all, 3.0 * chain);
  EXPECT_THAT(run({"uncertainty", "arm.toml", "--lengths", "5", "--rings", "2"}).out,
              HasSubstr("39 identified parameters"));
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
  EXPECT_THAT(unit.err, HasSubstr("expected 0 or a number above zero with its unit"));
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

class MonteCarloCommand : public testing::ProgramTest {
 protected:
  void SetUp() override { take("ball-bar"); }
  static std::vector<std::string> command(std::vector<std::string> more) {
    more.insert(more.begin(), {"uncertainty", "ball-bar/recording.toml", "--monte-carlo"});
    return more;
  }
  Ended made(const std::vector<std::string>& more) { return run(command(more)); }
};

TEST_F(MonteCarloCommand, TellsPeopleAndProgramsTheSame) {
  const Ended told = made({"--trials", "100", "--at", "600,0,450", "--at", "600,400,450"});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("identified 100 times"));
  EXPECT_THAT(told.out, HasSubstr("length 1 to 2"));
  const Ended json = made({"--trials", "100", "--at", "600,0,450", "--at", "600,400,450", "--json", "-"});
  const Json result = Json::parse(json.out);
  EXPECT_EQ(result["trials"]["made"], 100);
  bool there = false;
  for (const Json& quantity : result["quantities"]) {
    if (quantity["kind"] == "length" && quantity["name"] == "length 1 to 2") {
      there = true;
      EXPECT_NEAR(quantity["estimate"], 400.0, 1e-6);
      EXPECT_LT(quantity["interval_95"][0], 400.0);
      EXPECT_GT(quantity["interval_95"][1], 400.0);
    }
  }
  EXPECT_TRUE(there);
}

TEST_F(MonteCarloCommand, PutsShardsTogetherToTheSameBytes) {
  ASSERT_EQ(made({"--trials", "130", "--json", "whole.json", "--threads", "1"}).exit_code, 0);
  for (const std::string k : {"1", "2", "3"}) {
    ASSERT_EQ(made({"--trials", "130", "--shard", k + "/3", "--state", k + ".json", "--quiet"}).exit_code, 0);
  }
  const Ended merged = made({"--trials", "130", "--merge", "3.json,1.json,2.json", "--json", "merged.json"});
  EXPECT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(text_of("merged.json"), text_of("whole.json"));
  const Ended missing = made({"--trials", "130", "--merge", "3.json,1.json"});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_THAT(missing.err, HasSubstr("do not follow"));
  const Ended twice = made({"--trials", "130", "--merge", "1.json,1.json,2.json,3.json"});
  EXPECT_EQ(twice.exit_code, 3);
}

TEST_F(MonteCarloCommand, FollowsTheParametersOfAModelInTheirUnits) {
  const std::vector<std::string> asked{"--model", "dh+eccentricity+gain", "--trials", "90"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), asked.begin(), asked.end());
    return made(more);
  };
  const Ended told = with({"--threads", "1", "--json", "whole.json"});
  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("model dh+eccentricity+gain\n"));
  EXPECT_THAT(told.out, ::testing::ContainsRegex("cos_q3 +arcsec "));
  EXPECT_THAT(told.out, ::testing::ContainsRegex("gain6 +ppm "));
  const Json result = Json::parse(text_of("whole.json"));
  EXPECT_EQ(result["model"], "dh+eccentricity+gain");
  EXPECT_EQ(result["options"]["model"], "dh+eccentricity+gain");
  std::map<std::string, Json> found;
  for (const Json& quantity : result["quantities"]) {
    if (quantity["kind"] == "parameter") found[quantity["name"]] = quantity;
  }
  EXPECT_EQ(found.size(), 21U + 12U + 6U);
  EXPECT_EQ(found["sin_q2"]["unit"], "rad");
  EXPECT_EQ(found["gain2"]["unit"], "rad/rad");
  EXPECT_EQ(found["d2"]["unit"], "mm");
  // The arm of the example has no such errors.
  for (const char* name : {"sin_q2", "gain2"}) {
    EXPECT_LT(std::abs(found[name]["mean"].get<double>()), 4.0 * found[name]["u"].get<double>()) << name;
  }
  ASSERT_EQ(with({"--shard", "1/2", "--state", "1.json", "--quiet"}).exit_code, 0);
  ASSERT_EQ(with({"--shard", "2/2", "--state", "2.json", "--quiet"}).exit_code, 0);
  EXPECT_EQ(with({"--merge", "1.json,2.json", "--json", "merged.json"}).exit_code, 0);
  EXPECT_EQ(text_of("merged.json"), text_of("whole.json"));
  const Ended other = made({"--trials", "90", "--merge", "1.json,2.json"});
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_THAT(other.err, HasSubstr("with other options"));
}

TEST_F(MonteCarloCommand, TakesTheModelThatTheReadingsChoose) {
  const Ended told = made({"--model", "auto", "--trials", "20", "--json", "auto.json"});
  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("model dh, which these readings chose"));
  const Json chosen = Json::parse(text_of("auto.json"));
  EXPECT_EQ(chosen["model"], "dh");
  EXPECT_EQ(chosen["options"]["model"], "auto");
  ASSERT_EQ(made({"--trials", "20", "--json", "stated.json"}).exit_code, 0);
  EXPECT_EQ(Json::parse(text_of("stated.json"))["quantities"], chosen["quantities"]);
  const Ended refused = made({"--model", "dh+gravity", "--trials", "20"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("mass of its link"));
}

TEST_F(MonteCarloCommand, WritesWhatThereIsOnCtrlCAndGoesOnFromIt) {
  const pid_t child = start(command({"--trials", "50000000", "--state", "state.json", "--json", "stopped.json"}));
  for (int wait = 0; wait < 600 && !std::filesystem::exists(file("state.json")); ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  ::kill(child, SIGINT);
  const Ended ended = wait_for(child);
  ASSERT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("STOPPED after"));
  const Json stopped = Json::parse(text_of("stopped.json"));
  EXPECT_EQ(stopped["trials"]["complete"], false);
  const int made_so_far = stopped["trials"]["made"];
  EXPECT_GE(made_so_far, 2);
  const std::string all = std::to_string(made_so_far + 33);
  const Ended resumed = made({"--trials", all, "--resume", "state.json", "--json", "resumed.json"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  ASSERT_EQ(made({"--trials", all, "--json", "undisturbed.json"}).exit_code, 0);
  EXPECT_EQ(text_of("resumed.json"), text_of("undisturbed.json"));
}

TEST_F(MonteCarloCommand, RefusesStatesThatAreNotItsOwn) {
  ASSERT_EQ(made({"--trials", "20", "--state", "state.json"}).exit_code, 0);
  const std::string sound = text_of("state.json");
  const Ended other_seed = made({"--trials", "40", "--seed", "2", "--resume", "state.json"});
  EXPECT_EQ(other_seed.exit_code, 3);
  EXPECT_THAT(other_seed.err, HasSubstr("with other options"));
  const Ended fewer = made({"--trials", "10", "--resume", "state.json"});
  EXPECT_EQ(fewer.exit_code, 2);
  EXPECT_THAT(fewer.err, HasSubstr("more than the 10 asked for"));
  for (const std::string& damaged :
       {sound.substr(0, sound.size() / 2), std::string("{}"), testing::replaced(sound, "\"end\":20", "\"end\":21"),
        testing::replaced(sound, "\"end\":20", "\"end\":-1"), testing::replaced(sound, "\"end\":20", "\"end\":1e300"),
        std::string(100'000, '[')}) {
    write("damaged.json", damaged);
    const Ended refused = made({"--trials", "40", "--resume", "damaged.json"});
    EXPECT_EQ(refused.exit_code, 3) << refused.err;
    EXPECT_EQ(text_of("damaged.json"), damaged);
  }
}

TEST_F(MonteCarloCommand, RefusesWhatItCannotDo) {
  for (const auto& [more, why] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--trials", "some"}, "expected a number from 2"},
           {{"--trials", "1"}, "expected a number from 2"},
           {{"--trials", "20", "--at", "600,0"}, "expected coordinates"},
           {{"--trials", "20", "--shard", "1/2"}, "--state"},
           {{"--shard", "3/2", "--state", "s.json"}, "which of how many"},
           {{"--merge", "s.json"}, "--trials"},
           {{"--trials", "20", "--u-temperature", "0.1"}, "such as"},
           {{"--trials", "20", "--u-arm-temperature", "0.1 mm"}, "--u-arm-temperature is \"0.1 mm\""},
           {{"--trials", "20", "--noise", "0 um"}, "above zero"},
           {{"--trials", "20", "--probe", "star"}, "no probe"},
           {{"--trials", "20", "--lengths", "5"}, "exclude each other"}}) {
    const Ended refused = made(more);
    EXPECT_EQ(refused.exit_code, 2) << why;
    EXPECT_THAT(refused.err, HasSubstr(why));
  }
  const Ended without = run({"uncertainty", "ball-bar/arm.toml", "--trials", "20"});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_THAT(without.err, HasSubstr("--monte-carlo"));
  const Ended nowhere = made({"--trials", "20", "--state", "missing/state.json"});
  EXPECT_EQ(nowhere.exit_code, 3);
  const Ended far = made({"--trials", "20", "--at", "9000,0,0"});
  EXPECT_EQ(far.exit_code, 3);
  EXPECT_THAT(far.err, HasSubstr("does not reach"));
}

}  // namespace
}  // namespace artcal
