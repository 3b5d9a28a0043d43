// `artcal identify`: what it prints, writes and promises.
#include <sys/stat.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "acquisition/arm/arm_file.h"
#include "acquisition/arm/parameters.h"
#include "core/files/hash.h"
#include "tests/end_to_end/program.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Json = nlohmann::json;

class Identify : public testing::ProgramTest {};

const std::vector<std::string> bar{"identify", "two-socket-bar/recording.toml"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

// A result without the times it took.
std::string timeless(const std::string& text) {
  Json json = Json::parse(text);
  json.erase("timings_s");
  return json.dump();
}

TEST_F(Identify, TellsATechnicianWhatCameOut) {
  take("two-socket-bar");
  const Ended ended = run(bar);
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.err, IsEmpty());
  EXPECT_THAT(ended.out, HasSubstr("Panda on a two-socket bar\n"));
  EXPECT_THAT(ended.out, HasSubstr("387 readings, 12 features, 6 placements"));
  EXPECT_THAT(ended.out, ContainsRegex("rms +3\\.1964 +0\\.2048 +0\\.2137"));
  EXPECT_THAT(ended.out, ContainsRegex("worst certified length, error +\\+1\\.6694"));
  EXPECT_THAT(ended.out, ContainsRegex("frontright +60 +3\\.2572"));
  EXPECT_THAT(ended.out, ContainsRegex("d1 +mm +333\\.00000 +333\\.00000 +not identifiable"));
  EXPECT_THAT(ended.out, HasSubstr("25 of 31 parameters are identifiable"));
  EXPECT_THAT(ended.out, HasSubstr("lz + d7 is identifiable, d7 alone is not; d7 is fixed"));
  EXPECT_THAT(ended.out, HasSubstr("The identified arm was not written; add -o ARM.toml to keep it."));
  EXPECT_THAT(names(), ElementsAre("two-socket-bar")) << "nothing is left lying about";
}

// A diameter that is half of what was touched: residuals of 0.3 mm, which one feature has like the other.
TEST_F(Identify, AnArmThatDoesNotFitIsFourUnlessAccepted) {
  take("ball-bar");
  std::string artefact = text_of("ball-bar/bar.toml");
  for (auto at = artefact.find("25.4"); at != std::string::npos; at = artefact.find("25.4", at)) {
    artefact.replace(at, 4, "50.8");
  }
  write("ball-bar/bar.toml", artefact);
  const Ended refused = run({"identify", "ball-bar/recording.toml", "-o", "arm.toml", "--no-leave-out"});
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("no arm fits these readings"), HasSubstr("times the stated noise"),
                                 HasSubstr("--accept-misfit"), Not(HasSubstr("?."))));
  EXPECT_THAT(names(), ElementsAre("ball-bar"));
  const Ended accepted = run({"identify", "ball-bar/recording.toml", "-o", "arm.toml", "--no-leave-out",
                              "--accept-misfit", "--json", "result.json", "--report", "report.html"});
  EXPECT_EQ(accepted.exit_code, 0) << accepted.err;
  EXPECT_THAT(accepted.out, HasSubstr("no solution of its readings"));
  EXPECT_THAT(text_of("arm.toml"), HasSubstr("misfits = ["));
  EXPECT_THAT(text_of("report.html"), HasSubstr("no solution of its readings"));
  const Json result = Json::parse(text_of("result.json"));
  EXPECT_EQ(result["termination"]["status"], "misfit accepted");
  EXPECT_FALSE(result["termination"]["misfits"].empty());
  const auto arm = read_arm_file(file("arm.toml"));
  ASSERT_TRUE(arm) << arm.error().text();
  EXPECT_FALSE(arm->identification->misfits.empty());
}

TEST_F(Identify, ACertificateCopiedWronglyIsNamed) {
  take("ball-bar");
  // Positions typed in as if they were steps.
  std::string bar_text = text_of("ball-bar/bar.toml");
  bar_text.resize(bar_text.find("[[distance]]"));
  write("ball-bar/bar.toml", bar_text +
                                 "[[distance]]\nalong = [\"0\", \"1\", \"2\", \"3\"]\n"
                                 "steps = [250.0123, 600.0045, 1000.0078]\nU = 0.0008\nk = 2\n");
  const Ended ended = run({"identify", "ball-bar/recording.toml"});
  EXPECT_EQ(ended.exit_code, 4);
  EXPECT_THAT(ended.err, HasSubstr("the certified distance of \"2\" and \"3\" of artefact \"ball bar 1000\" is "
                                   "1000.01 mm, but the nominal arm reads 39"));
}

TEST_F(Identify, WritesTheArmAndTheResult) {
  take("two-socket-bar");
  const Ended ended = run(with(bar, {"-o", "arm.toml", "--json", "r.json"}));
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("The identified arm is in arm.toml."));
  EXPECT_THAT(names(), ElementsAre("arm.toml", "r.json", "two-socket-bar"));

  const Json json = Json::parse(text_of("r.json"));
  const auto arm = read_arm_file(file("arm.toml"));
  ASSERT_TRUE(arm) << arm.error().text();
  ASSERT_TRUE(arm->identification);
  EXPECT_EQ(arm->identification->recording, sha256(text_of("two-socket-bar/recording.toml")));
  EXPECT_EQ(json["inputs"][0]["sha256"], arm->identification->recording);
  EXPECT_EQ(Json(arm->identification->parameters), json["covariance"]["parameters"]);
  EXPECT_EQ(arm->identification->parameters.size(), 25u);
  const Eigen::MatrixXd& covariance = arm->identification->covariance;
  for (int i = 0; i < 25; ++i) {
    for (int j = 0; j < 25; ++j) {
      EXPECT_EQ(covariance(i, j), json["covariance"]["matrix"][i][j].get<double>()) << i << ", " << j;
    }
  }
  int identified = 0;
  const auto parameters = parameters_of(arm->arm);
  for (const Json& parameter : json["parameters"]) {
    const int index = find_parameter(parameters, parameter["name"].get<std::string>());
    ASSERT_GE(index, 0);
    EXPECT_EQ(value(arm->arm, parameters[index]), parameter["identified"].get<double>()) << parameter["name"];
    if (parameter["state"] == "identified") {
      EXPECT_DOUBLE_EQ(parameter["standard_uncertainty"].get<double>(), std::sqrt(covariance(identified, identified)));
      ++identified;
    } else {
      EXPECT_TRUE(parameter["standard_uncertainty"].is_null());
      EXPECT_EQ(parameter["identified"], parameter["nominal"]);
    }
  }
  EXPECT_EQ(identified, 25);
}

// An arm identified with its encoders' harmonics carries them in its file, to every command that takes an arm.
// As artcal arm round does with the arm that is written whole.
TEST_F(Identify, WritesARoundedArm) {
  take("two-socket-bar");
  const auto identified = [&](const std::vector<std::string>& more) {
    return run(with(with(bar, {"--no-leave-out"}), more));
  };
  ASSERT_EQ(identified({"-o", "whole.toml"}).exit_code, 0);
  for (const std::vector<std::string>& rounding :
       {std::vector<std::string>{"--digits", "2"}, {"--steps", "length=0.01in,angle=1arcsec"}}) {
    const Ended ended = identified(with(rounding, {"-o", "rounded.toml"}));
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("rounding moves the tip by "));
    EXPECT_THAT(ended.out, HasSubstr("The rounded arm is in rounded.toml, without its covariance."));
    ASSERT_EQ(run(with({"arm", "round", "whole.toml", "-o", "again.toml"}, rounding)).exit_code, 0);
    EXPECT_EQ(text_of("rounded.toml"), text_of("again.toml"));
    EXPECT_NE(text_of("rounded.toml"), text_of("whole.toml"));
  }
  EXPECT_THAT(identified({"--digits", "2"}).err, HasSubstr("round the arm that is written; add -o ARM.toml"));
  EXPECT_THAT(identified({"--digits", "2", "--steps", "length=1mm", "-o", "no.toml"}).err,
              HasSubstr("expected one of them"));
  EXPECT_THAT(identified({"--steps", "length=1", "-o", "no.toml"}).err, HasSubstr("--steps has \"length=1\""));
  EXPECT_FALSE(std::filesystem::exists(file("no.toml")));
}

TEST_F(Identify, RicherModelsAreInTheArmThatIsWritten) {
  take("two-socket-bar");
  const Ended ended = run(
      with(bar, {"--model", "dh+eccentricity2", "--hold", "cos_2q7,sin_2q7", "-o", "arm.toml", "--json", "r.json"}));
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("model dh+eccentricity2"));
  EXPECT_THAT(ended.out, ContainsRegex("cos_2q2 +arcsec"));
  const Json json = Json::parse(text_of("r.json"));
  EXPECT_EQ(json["model"]["groups"], Json({"eccentricity2"}));
  EXPECT_EQ(json["covariance"]["parameters"].size(), 25u + 12u);
  const auto arm = read_arm_file(file("arm.toml"));
  ASSERT_TRUE(arm) << arm.error().text();
  for (const Json& parameter : json["parameters"]) {
    if (parameter["name"] == "cos_2q2") {
      EXPECT_EQ(arm->arm.joints[1].errors.cosine[1], parameter["identified"].get<double>());
    }
  }
  const Ended points = run({"points", "two-socket-bar/recording.toml", "--arm", "arm.toml"});
  EXPECT_EQ(points.exit_code, 0) << points.err;
  EXPECT_EQ(run({"uncertainty", "arm.toml"}).exit_code, 0);
  // The arm as it was written explains the readings as well as it did.
  write("two-socket-bar/recording.toml",
        testing::replaced(text_of("two-socket-bar/recording.toml"), "\"arm.toml\"", "\"../arm.toml\""));
  ASSERT_EQ(run(with(bar, {"--json", "second.json", "--quiet"})).exit_code, 0);
  EXPECT_NEAR(Json::parse(text_of("second.json"))["before"]["overall"]["rms_mm"].get<double>(),
              json["after"]["overall"]["rms_mm"].get<double>(), 1e-9);
}

TEST_F(Identify, ModelsThatMakeNoSenseAreRefused) {
  take("two-socket-bar");
  const Ended thermal = run(with(bar, {"--model", "dh+thermal"}));
  EXPECT_EQ(thermal.exit_code, 2);
  EXPECT_THAT(thermal.err, HasSubstr("arm_temperature"));
  // The flange hardly turns the tip, which is nearly on its axis: nothing is made of its encoder's first harmonic.
  const Ended absurd = run(with(bar, {"--free", "cos_q7,sin_q7", "-o", "arm.toml"}));
  EXPECT_EQ(absurd.exit_code, 4);
  EXPECT_THAT(absurd.err, HasSubstr("no joint that works has such errors"));
  EXPECT_THAT(absurd.err, HasSubstr("--hold"));
  EXPECT_THAT(names(), ElementsAre("two-socket-bar"));
  // As members of a group they are fixed, and the group stays.
  const Ended group = run(with(bar, {"--model", "dh+eccentricity", "--no-leave-out"}));
  EXPECT_EQ(group.exit_code, 0) << group.err;
  EXPECT_THAT(group.out, HasSubstr("sin_q7 of the group eccentricity is fixed"));
  const Ended radius = run(with(bar, {"--model", "dh+radius"}));
  EXPECT_EQ(radius.exit_code, 4);
  EXPECT_THAT(radius.err, HasSubstr("the group radius was asked for, but these readings identify no parameter of it"));
  write("two-socket-bar/recording.toml", text_of("two-socket-bar/recording.toml") + "\n[identify]\nmodel = \"dh+x\"\n");
  const Ended stated = run(bar);
  EXPECT_EQ(stated.exit_code, 3);
  EXPECT_THAT(stated.err, HasSubstr("recording.toml, [identify]: the model \"dh+x\" names \"x\""));
}

TEST_F(Identify, TheIdentifiedArmIsAnArmForTheNextRecording) {
  take("two-socket-bar");
  ASSERT_EQ(run(with(bar, {"-q", "-o", "two-socket-bar/identified.toml", "--json", "first.json"})).exit_code, 0);
  write("two-socket-bar/recording.toml",
        testing::replaced(text_of("two-socket-bar/recording.toml"), "\"arm.toml\"", "\"identified.toml\""));
  const Ended again = run(with(bar, {"--json", "second.json", "--quiet"}));
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const Json first = Json::parse(text_of("first.json"));
  const Json second = Json::parse(text_of("second.json"));
  EXPECT_EQ(second["coupling"]["rank"], 25) << "before and after identification alike";
  const double rms = first["after"]["overall"]["rms_mm"].get<double>();
  EXPECT_NEAR(second["before"]["overall"]["rms_mm"].get<double>(), rms, 1e-9);
  EXPECT_NEAR(second["after"]["overall"]["rms_mm"].get<double>(), rms, 1e-6);
}

TEST_F(Identify, JsonOnStandardOutputIsNothingButJson) {
  take("two-socket-bar");
  const Ended ended = run(with(bar, {"--json", "-"}));
  ASSERT_EQ(ended.exit_code, 0);
  const Json json = Json::parse(ended.out);
  EXPECT_EQ(json["kind"], "identification");
  EXPECT_THAT(ended.err, IsEmpty());
}

TEST_F(Identify, QuietPrintsNothing) {
  take("two-socket-bar");
  const Ended ended = run(with(bar, {"--quiet", "-o", "arm.toml"}));
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_THAT(ended.err, IsEmpty());
  EXPECT_THAT(names(), ElementsAre("arm.toml", "two-socket-bar"));
}

TEST_F(Identify, TheSameInputGivesTheSameBytesWhateverTheThreads) {
  for (const char* example : {"two-socket-bar", "ball-bar"}) {
    take(example);
    const std::vector<std::string> command{"identify", std::string(example) + "/recording.toml", "-q"};
    ASSERT_EQ(run(with(command, {"-o", "first.toml", "--json", "first.json"})).exit_code, 0);
    const std::string arm = text_of("first.toml");
    const std::string json = timeless(text_of("first.json"));
    for (const char* threads : {"0", "1", "2", "4"}) {
      ASSERT_EQ(run(with(command, {"-o", "again.toml", "--json", "again.json", "--threads", threads})).exit_code, 0);
      EXPECT_EQ(text_of("again.toml"), arm) << example << ", threads " << threads;
      EXPECT_EQ(timeless(text_of("again.json")), json) << example << ", threads " << threads;
    }
  }
}

TEST_F(Identify, FindsTheSimulatedArmOfTheBallBar) {
  take("ball-bar");
  const Ended ended = run({"identify", "ball-bar/recording.toml", "--json", "r.json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const Json json = Json::parse(text_of("r.json"));
  // The noise is 2 arcsec and 3 µm: χ² within what 95 % of sound fits show.
  EXPECT_GT(json["noise"]["chi_squared"].get<double>(), json["noise"]["chi_squared_95"][0].get<double>());
  EXPECT_LT(json["noise"]["chi_squared"].get<double>(), json["noise"]["chi_squared_95"][1].get<double>());
  EXPECT_TRUE(json["noise"]["given"].get<bool>());
}

TEST_F(Identify, OptionsReachTheResult) {
  take("two-socket-bar");
  ASSERT_EQ(run(with(bar, {"-q", "--hold", "lx,ly", "--loss", "huber", "--noise", "200 um", "--no-leave-out", "--json",
                           "r.json"}))
                .exit_code,
            0);
  const Json json = Json::parse(text_of("r.json"));
  EXPECT_EQ(json["options"]["hold"], Json({"lx", "ly"}));
  EXPECT_EQ(json["options"]["loss"], "huber");
  EXPECT_EQ(json["options"]["leave_out"], false);
  EXPECT_THAT(json["left_out"], IsEmpty());
  EXPECT_EQ(json["noise"]["mm"], 0.2);
  for (const Json& parameter : json["parameters"]) {
    EXPECT_TRUE((parameter["name"] != "lx" && parameter["name"] != "ly") || parameter["state"] == "fixed");
  }
}

TEST_F(Identify, SaysWhatToMeasureWhereTheScaleIsLost) {
  take("two-socket-bar");
  const std::string text = text_of("two-socket-bar/bar.toml");
  write("two-socket-bar/bar.toml", text.substr(0, text.find("[[distance]]")));
  const Ended ended = run(with(bar, {"-o", "arm.toml", "--json", "r.json"}));
  EXPECT_EQ(ended.exit_code, 4);
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_THAT(ended.err, HasSubstr("scale"));
  EXPECT_THAT(ended.err, ContainsRegex("measure|certified|calibrated"));
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1);
  EXPECT_THAT(names(), ElementsAre("two-socket-bar")) << "no result, no file";
}

TEST_F(Identify, SaysWhereThereAreTooFewReadings) {
  take("two-socket-bar");
  const std::string text = text_of("two-socket-bar/readings.csv");
  std::size_t end = 0;
  for (int line = 0; line < 6; ++line) {
    end = text.find('\n', end) + 1;
  }
  write("two-socket-bar/readings.csv", text.substr(0, end));
  const Ended ended = run(bar);
  EXPECT_EQ(ended.exit_code, 4);
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1);
}

TEST_F(Identify, WrongUsageIsTwo) {
  take("two-socket-bar");
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{with(bar, {"--frobnicate"}),
                                             with(bar, {"--hold", "a99"}),
                                             with(bar, {"--free", "nonsense"}),
                                             with(bar, {"--loss", "tukey"}),
                                             with(bar, {"--noise", "15"}),
                                             with(bar, {"--noise", "-1 um"}),
                                             with(bar, {"--noise", "1 um", "--encoder-noise", "1 arcsec"}),
                                             with(bar, {"--encoder-noise", "1 arcsec"}),
                                             with(bar, {"--threads", "-1"}),
                                             with(bar, {"--threads", "many"}),
                                             with(bar, {"another.toml"}),
                                             with(bar, {"--hold", "a1", "--free", "a1"}),
                                             with(bar, {"-o", "two-socket-bar/arm.toml"}),
                                             with(bar, {"--json", "two-socket-bar/../two-socket-bar/readings.csv"}),
                                             with(bar, {"-o", "x.toml", "--json", "./x.toml"}),
                                             {"identify"},
                                             {"indentify", "two-socket-bar/recording.toml"},
                                             {}}) {
    const Ended ended = run(wrong);
    EXPECT_EQ(ended.exit_code, 2) << fmt::format("{}", fmt::join(wrong, " "));
    EXPECT_THAT(ended.err, Not(IsEmpty()));
    EXPECT_THAT(ended.out, IsEmpty());
  }
  EXPECT_THAT(run(with(bar, {"--hold", "a99"})).err, HasSubstr("\"a99\""));
  EXPECT_THAT(names(), ElementsAre("two-socket-bar"));
}

// Numbers of a file that no arm has end in a sentence, not in the solver's log.
TEST_F(Identify, NumbersThatBreakDownAreToldInOneLine) {
  take("two-socket-bar");
  write("two-socket-bar/arm.toml", testing::replaced(text_of("two-socket-bar/arm.toml"), "d = 333", "d = 3e155"));
  const Ended ended = run(bar);
  EXPECT_NE(ended.exit_code, 0);
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
}

TEST_F(Identify, ANameListDoesNotSwallowTheRecording) {
  take("two-socket-bar");
  EXPECT_EQ(run({"identify", "-q", "--hold", "lx,ly", "two-socket-bar/recording.toml"}).exit_code, 0);
}

TEST_F(Identify, BadInputIsThreeInOneLineWithItsPlace) {
  take("two-socket-bar");
  const auto refused = [&](const std::string& name, const std::string& from, const std::string& to) {
    const std::string path = "two-socket-bar/" + name;
    const std::string good = text_of(path);
    const std::size_t at = good.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    write(path, std::string(good).replace(at, from.size(), to));
    const Ended ended = run(with(bar, {"-o", "arm.toml", "--json", "r.json"}));
    write(path, good);
    EXPECT_EQ(ended.exit_code, 3) << name << ": " << to << "\n" << ended.err;
    EXPECT_THAT(ended.out, IsEmpty());
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_THAT(names(), ElementsAre("two-socket-bar"));
    return ended.err;
  };
  EXPECT_THAT(refused("recording.toml", "\"arm.toml\"", "\"none.toml\""),
              HasSubstr("none.toml: there is no such file"));
  EXPECT_THAT(refused("recording.toml", "\"bar.toml\"", "\"arm.toml\""), HasSubstr("arm.toml:3:10: schema is"));
  EXPECT_THAT(refused("recording.toml", "joint = \"rad\"", "joint = \"turns\""), HasSubstr("recording.toml:6:"));
  EXPECT_THAT(refused("recording.toml", "name =", "nam ="), HasSubstr("\"nam\" is not a key"));
  EXPECT_THAT(refused("recording.toml", "\"Panda on a two-socket bar\"", "\"a\\u001b[2J\\nb\""),
              Not(HasSubstr("\x1b")));
  EXPECT_THAT(refused("arm.toml", "d = 333", "d = \"333\""), HasSubstr("arm.toml:"));
  EXPECT_THAT(refused("arm.toml", "d = 333", "d = nan"), HasSubstr("finite"));
  EXPECT_THAT(refused("bar.toml", "U = 0.03", "U = 0"), HasSubstr("bar.toml:"));
  EXPECT_THAT(refused("bar.toml", "k = 2", ""), HasSubstr("`k` is missing"));
  EXPECT_THAT(refused("readings.csv", "q7", "q8"), HasSubstr("readings.csv:1:"));
  EXPECT_THAT(refused("readings.csv", "backcenter,0,-1.7144672064153748", "backcenter,9,-1.7144672064153748"),
              HasSubstr("readings.csv:2: the reading names the feature \"9\""));
  EXPECT_THAT(refused("readings.csv", "-1.5636452542649983", "inf"), HasSubstr("readings.csv:3:14"));
  EXPECT_THAT(refused("readings.csv", "-1.5636452542649983", "-1,5636452542649983"), HasSubstr("readings.csv:3:1"));
  EXPECT_EQ(run({"identify", "none.toml"}).exit_code, 3);
  EXPECT_EQ(run({"identify", ""}).exit_code, 3);
  EXPECT_EQ(run({"identify", "two-socket-bar"}).exit_code, 3) << "a folder";
  EXPECT_EQ(run({"identify", "/dev/null"}).exit_code, 3);
}

TEST_F(Identify, LongAndMarkedUpNamesStayHarmless) {
  take("two-socket-bar");
  const std::string longest(900, 'x');
  const std::string label = "<script>alert('" + longest + "')</script> & \"\" ${HOME} µ %s {}";
  std::string readings = text_of("two-socket-bar/readings.csv");
  for (std::size_t at = 0; (at = readings.find("backleft", at)) != std::string::npos; at += label.size()) {
    readings.replace(at, 8, "\"" + label + "\"");
  }
  write("two-socket-bar/readings.csv", readings);
  const Ended ended = run(with(bar, {"--json", "r.json", "-o", "arm.toml"}));
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  std::size_t longest_line = 0;
  for (std::size_t at = 0; at < ended.out.size();) {
    const std::size_t end = std::min(ended.out.find('\n', at), ended.out.size());
    longest_line = std::max(longest_line, end - at);
    at = end + 1;
  }
  EXPECT_LT(longest_line, 400u);
  const std::string text = text_of("r.json");
  const Json json = Json::parse(text);
  std::string unquoted = label;
  unquoted.replace(unquoted.find("\"\""), 2, "\"");
  EXPECT_EQ(json["after"]["placements"][1]["placement"], unquoted) << "JSON has it whole";
  EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= 0x20 && c < 0x7f); }));
}

TEST_F(Identify, AnOutputThatCannotBeWrittenIsThreeAndLeavesNothing) {
  take("two-socket-bar");
  std::filesystem::create_directory(file("folder"));
  for (const char* output :
       {"folder", "no/such/folder/arm.toml", "two-socket-bar/bar.toml/arm.toml", "/proc/arm.toml"}) {
    for (const char* option : {"-o", "--json"}) {
      const Ended ended = run(with(bar, {option, output}));
      EXPECT_EQ(ended.exit_code, 3) << option << " " << output;
      EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    }
  }
  EXPECT_TRUE(std::filesystem::is_empty(file("folder")));
  EXPECT_THAT(names(), ElementsAre("folder", "two-socket-bar"));
}

TEST_F(Identify, AReadOnlyFolderIsThree) {
  if (::geteuid() == 0) {
    GTEST_SKIP() << "root may write anywhere";
  }
  take("two-socket-bar");
  std::filesystem::create_directory(file("closed"));
  std::filesystem::permissions(file("closed"), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_EQ(run(with(bar, {"-o", "closed/arm.toml"})).exit_code, 3);
  std::filesystem::permissions(file("closed"), std::filesystem::perms::owner_all);
  EXPECT_TRUE(std::filesystem::is_empty(file("closed")));
}

// No device of the machine is named as an output in these tests: a program that is broken and run by root
// would replace it. A limit stands in for the full disk, a pipe for the device.
TEST_F(Identify, AFullDiskIsThreeAndLeavesTheOldFile) {
  take("two-socket-bar");
  for (const char* option : {"-o", "--json"}) {
    write("out.txt", "old");
    const Ended ended = wait_for(start(with(bar, {"-q", option, "out.txt"}), 2000));
    EXPECT_EQ(ended.exit_code, 3) << option;
    EXPECT_THAT(ended.err, HasSubstr("out.txt: the file cannot be written"));
    EXPECT_EQ(text_of("out.txt"), "old");
    EXPECT_THAT(names(), ElementsAre("out.txt", "two-socket-bar"));
  }
}

TEST_F(Identify, LinksStayLinks) {
  take("two-socket-bar");
  write("real.toml", "old");
  std::filesystem::create_symlink("real.toml", file("link.toml"));
  ASSERT_EQ(run(with(bar, {"-q", "-o", "link.toml"})).exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(file("link.toml")));
  EXPECT_TRUE(read_arm_file(file("real.toml")));
}

TEST_F(Identify, WhatIsNoFileIsWrittenToAndNotReplaced) {
  take("two-socket-bar");
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
  // Open for both, so that nobody waits; a pipe takes 64 KiB, an arm is a quarter of that.
  const int pipe = ::open(file("pipe").c_str(), O_RDWR | O_NONBLOCK);
  ASSERT_GE(pipe, 0);
  EXPECT_EQ(run(with(bar, {"-q", "-o", "pipe"})).exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_fifo(file("pipe")));
  std::string text(1 << 16, '\0');
  const ssize_t size = ::read(pipe, text.data(), text.size());
  ::close(pipe);
  ASSERT_GT(size, 0);
  EXPECT_THAT(text, HasSubstr("schema = \"artcal-arm/1\""));
}

TEST_F(Identify, AFailureLeavesTheOldFilesWhole) {
  take("two-socket-bar");
  write("arm.toml", "old arm");
  write("r.json", "old result");
  write("two-socket-bar/bar.toml", testing::replaced(text_of("two-socket-bar/bar.toml"), "value = 50", "value = -50"));
  EXPECT_EQ(run(with(bar, {"-o", "arm.toml", "--json", "r.json"})).exit_code, 3);
  EXPECT_EQ(text_of("arm.toml"), "old arm");
  EXPECT_EQ(text_of("r.json"), "old result");
}

// A file written in place would change under its other name too.
TEST_F(Identify, TheOldFileIsReplacedNotWrittenOver) {
  take("two-socket-bar");
  for (const char* name : {"arm.toml", "r.json"}) {
    write(name, "old");
    std::filesystem::create_hard_link(file(name), file(std::string("kept-") + name));
  }
  ASSERT_EQ(run(with(bar, {"-q", "-o", "arm.toml", "--json", "r.json"})).exit_code, 0);
  EXPECT_EQ(text_of("kept-arm.toml"), "old");
  EXPECT_EQ(text_of("kept-r.json"), "old");
  EXPECT_TRUE(read_arm_file(file("arm.toml")));
  EXPECT_TRUE(Json::accept(text_of("r.json")));
}

// Killed at moments spread over the time that a run takes, most of them near its end, where it writes.
TEST_F(Identify, AKilledRunLeavesTheOldFileOrTheNewOne) {
  take("two-socket-bar");
  const auto before = std::chrono::steady_clock::now();
  ASSERT_EQ(run(with(bar, {"-q", "-o", "new.toml"})).exit_code, 0);
  const auto whole = std::chrono::steady_clock::now() - before;
  const std::string fresh = text_of("new.toml");
  int killed = 0;
  for (int i = 0; i < 40; ++i) {
    write("arm.toml", "old");
    const pid_t child = start(with(bar, {"-q", "-o", "arm.toml"}));
    std::this_thread::sleep_for(whole * (i < 10 ? i * 0.08 : 0.8 + 0.01 * (i - 10)));
    ::kill(child, SIGKILL);
    killed += wait_for(child).signal == SIGKILL ? 1 : 0;
    const std::string left = text_of("arm.toml");
    EXPECT_TRUE(left == "old" || left == fresh) << left.size() << " bytes";
  }
  EXPECT_GT(killed, 0);
}

}  // namespace
}  // namespace artcal
