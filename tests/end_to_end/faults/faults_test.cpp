// What goes wrong around the program: limits of the system, folders that cannot be read, names in old encodings.
#include <cmath>
#include <thread>

#include <gmock/gmock.h>
#include <sqlite3.h>
#include <nlohmann/json.hpp>

#include "acquisition/recording/recording_file.h"
#include "tests/end_to_end/archive.h"
#include "tests/support/sanitizers/sanitized.h"

namespace artcal {
namespace {

using ::testing::ContainsRegex;
using testing::count_of;
using ::testing::ElementsAre;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

class Faults : public testing::ArchiveTest {
 protected:
  // Runs the program as a user for whom permissions hold.
  [[nodiscard]] Ended run_as_nobody(std::vector<std::string> arguments) const {
    std::vector<std::string> command;
    std::string program = ARTCAL_PROGRAM;
    if (::geteuid() == 0) {
      namespace fs = std::filesystem;
      program = (folder("work") / "program").string();
      fs::copy_file(ARTCAL_PROGRAM, program, fs::copy_options::skip_existing);
      fs::permissions(folder("work"), fs::perms::all);
      fs::permissions(folder("work").parent_path(), fs::perms::all);
      command = {"setpriv", "--reuid", "65534", "--regid", "65534", "--clear-groups"};
    }
    command.push_back(program);
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_command(command);
  }
};

TEST_F(Faults, AFolderThatMayNotBeReadIsNamedAndTheRestGoesOn) {
  file_away_quick_ones(2);
  std::filesystem::create_directories(file("archive/lost+found"));
  std::filesystem::permissions(file("archive/lost+found"), std::filesystem::perms::none);
  const Ended ended = run_as_nobody({"batch", "archive", "--store", "s.sqlite", "--report", "i.html"});
  std::filesystem::permissions(file("archive/lost+found"), std::filesystem::perms::owner_all);
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.out, ContainsRegex("identified +2"));
  EXPECT_THAT(ended.out, ContainsRegex("folders that could not be read +1"));
  EXPECT_THAT(ended.out, HasSubstr("lost+found"));
  EXPECT_THAT(text_of("i.html"), HasSubstr("lost+found"));
  EXPECT_EQ(count_of(dump("s.sqlite"), "[\"files\","), 2);
}

TEST_F(Faults, PathsThatAreNotUtf8AreInTheIndex) {
  const std::string name = "archive/M\374ller";
  file_away_quick_ones(1);
  std::filesystem::create_directories(file(name));
  write(name + "/recording.toml", "nonsense");
  const Ended ended = batch({"--store", "s.sqlite", "--report", "i.html", "--json", "s.json"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(text_of("i.html"), HasSubstr("2 recordings: 1 done"));
  EXPECT_THAT(text_of("i.html"), HasSubstr("M\\xfcller"));
  EXPECT_THAT(Json::parse(text_of("s.json"))["failures"][0]["path"].get<std::string>(), HasSubstr("M\\xfcller"));
}

TEST_F(Faults, AMovedRecordingIsTheSameAndAMistypedPathLeavesNothing) {
  file_away_quick_ones(2);
  ASSERT_EQ(batch({"--store", "s.sqlite", "-q"}).exit_code, 0);
  std::filesystem::create_directories(file("archive/2026/march"));
  std::filesystem::rename(file("archive/quick-000"), file("archive/2026/march/quick"));
  std::filesystem::rename(file("archive/quick-001/recording.toml"), file("archive/quick-001/monday-recording.toml"));
  const Ended again = batch({"--store", "s.sqlite", "--resume", "archive/mistyped.toml", "--report", "i.html"});
  EXPECT_EQ(again.exit_code, 3);
  EXPECT_THAT(again.out, ContainsRegex("identified +2"));
  EXPECT_THAT(again.out, HasSubstr("mistyped.toml"));
  EXPECT_THAT(text_of("i.html"), HasSubstr("mistyped.toml"));
  const std::string stored = dump("s.sqlite");
  EXPECT_EQ(count_of(stored, "[\"recordings\","), 2);
  EXPECT_EQ(count_of(stored, "[\"files\","), 2) << stored;
  EXPECT_THAT(stored, Not(HasSubstr("mistyped")));
}

TEST_F(Faults, ABatchThatIsQuietSaysWhyItFailed) {
  file_away_quick_ones(1);
  write("archive/bad/recording.toml", "nonsense");
  const Ended ended = batch({"--store", "s.sqlite", "-q"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(count_of(ended.err, "\n"), 1) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("1 of 2 recordings failed, the first is"));
}

TEST_F(Faults, TheLargestFileThatTheSystemAllowsIsToldAndCleanedUp) {
  take("gao2013");
  const Ended ended = run_command({"bash", "-c",
                                   std::string("ulimit -f 1; exec ") + ARTCAL_PROGRAM +
                                       " identify gao2013/recording.toml -q --no-leave-out --json result.json"});
  EXPECT_EQ(ended.signal, 0);
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("result.json: the file cannot be written: File too large"));
  EXPECT_THAT(names(), ElementsAre("gao2013"));
}

TEST_F(Faults, AStoreThatIsBeingWrittenIsNotTakenForOneThatWasKilled) {
  file_away_quick_ones(1);
  ASSERT_EQ(batch({"--store", "s.sqlite", "-q"}).exit_code, 0);
  sqlite3* other = nullptr;
  ASSERT_EQ(sqlite3_open(file("s.sqlite").c_str(), &other), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(other, "BEGIN EXCLUSIVE; DELETE FROM remarks; UPDATE files SET exit_code = 1", nullptr,
                         nullptr, nullptr),
            SQLITE_OK);
  ASSERT_TRUE(std::filesystem::exists(file("s.sqlite-journal")));
  const Ended ended = run({"history", "x", "--store", "s.sqlite"});
  sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr);
  sqlite3_close(other);
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("another process has kept it locked"));
  EXPECT_THAT(ended.err, Not(HasSubstr("killed")));
}

TEST_F(Faults, NoiseAndUncertaintiesThatNothingHasAreRefused) {
  take("ball-bar");
  const std::string recording = text_of("ball-bar/recording.toml");
  for (const char* noise : {"1e-300 um", "1e300 mm"}) {
    std::string text = recording;
    replace_in(text, "3 um", noise);
    write("ball-bar/recording.toml", text);
    EXPECT_THAT(run({"identify", "ball-bar/recording.toml"}).err, HasSubstr("is the unit right?")) << noise;
  }
  write("ball-bar/recording.toml", recording);
  EXPECT_THAT(run({"identify", "ball-bar/recording.toml", "--noise", "1e-300 mm"}).err,
              HasSubstr("is the unit right?"));
  const std::string bar = text_of("ball-bar/bar.toml");
  const std::size_t at = bar.find("\nU = ");
  ASSERT_NE(at, std::string::npos);
  const std::size_t end = bar.find('\n', at + 1);
  write("ball-bar/bar.toml", bar.substr(0, at) + "\nU = 1e-300" + bar.substr(end));
  EXPECT_THAT(run({"identify", "ball-bar/recording.toml"}).err, HasSubstr("a standard uncertainty U/k of"));
}

TEST_F(Faults, WhatIsTooLargeIsRefusedBeforeItIsRead) {
  if (testing::is_sanitized) {
    GTEST_SKIP() << "a sanitizer takes more addresses than the limit";
  }
  take("gao2013");
  for (const char* name : {"recording.toml", "table1.toml", "coordinates.toml"}) {
    const std::string path = std::string("gao2013/") + name;
    const auto size = std::filesystem::file_size(file(path));
    std::filesystem::resize_file(file(path), std::uintmax_t{3500} << 20);  // sparse
    const Ended ended = run_command({"bash", "-c",
                                     std::string("ulimit -v 2000000; exec ") + ARTCAL_PROGRAM +
                                         " identify gao2013/recording.toml -q --no-leave-out"});
    EXPECT_THAT(ended.err, HasSubstr("more than the 16777216 that are read")) << name;
    std::filesystem::resize_file(file(path), size);
  }
}

TEST_F(Faults, LongNamesDoNotMakeLongMessages) {
  take("gao2013");
  const std::string name(300000, 'x');
  const std::string recording = text_of("gao2013/recording.toml");
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"\"Gao 2013, Table 3\"", "\"" + name + "\""},
                                 {"\"table1.toml\"", "\"" + name + "\""},
                                 {"\"readings.csv\"", "\"" + name + "\""}}) {
    std::string text = recording;
    replace_in(text, from, to);
    write("gao2013/recording.toml", text);
    const Ended ended = run({"identify", "gao2013/recording.toml", "-q"});
    EXPECT_EQ(ended.exit_code, 3);
    EXPECT_LT(ended.err.size(), 3000u) << from;
  }
  write("gao2013/recording.toml", recording);
  std::string readings = text_of("gao2013/readings.csv");
  const std::size_t row = readings.find("\n1,");
  ASSERT_NE(row, std::string::npos);
  write("gao2013/readings.csv", readings.insert(row + 1, name));
  const Ended label = run({"identify", "gao2013/recording.toml", "-q"});
  EXPECT_THAT(label.err, HasSubstr("of 300001 characters, expected at most 1000"));
  EXPECT_LT(label.err.size(), 3000u);
}

TEST_F(Faults, WhatLooksWrongInReadingsIsToldByPointsAndByFailures) {
  take("ball-bar");
  change("ball-bar/recording.toml", "joint = \"deg\"", "joint = \"rad\"");
  EXPECT_THAT(run({"points", "ball-bar/recording.toml", "-o", "p.csv"}).out, HasSubstr("look like degrees"));
  EXPECT_THAT(run({"points", "ball-bar/recording.toml"}).err, HasSubstr("look like degrees"));
  EXPECT_EQ(run({"points", "ball-bar/recording.toml", "-q"}).err, "");
  const Ended failed = run({"identify", "ball-bar/recording.toml"});
  EXPECT_NE(failed.exit_code, 0);
  EXPECT_THAT(failed.err, HasSubstr("look like degrees"));
}

TEST_F(Faults, PointsWritesLabelsAsReadingsHaveThem) {
  take("ball-bar");
  const std::string beginning = "schema = \"artcal-recording/1\"\n";
  write("ball-bar/r.toml", beginning +
                               "arm = \"arm.toml\"\nreadings = [\"r.csv\"]\n"
                               "units = { joint = \"deg\", length = \"mm\" }\n");
  write("ball-bar/r.csv",
        "artefact,placement,feature,orientation,repeat,q1,q2,q3,q4,q5,q6\n"
        "\"bar; left\",\"#1\",\" A \",'=cmd|' /C calc'!A0,-1,1,2,3,4,5,6\n"
        "\"a,b\",\"say \"\"x\"\"\",@SUM,+x,''=1,1,2,3,4,5,7\n");
  const Ended ended = run({"points", "ball-bar/r.toml", "-o", "ball-bar/p.csv", "--json", "p.json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const std::string table = text_of("ball-bar/p.csv");
  EXPECT_THAT(table, Not(ContainsRegex("(^|[,\"])[=@]")));
  EXPECT_THAT(table, HasSubstr("'@SUM"));
  EXPECT_THAT(table, HasSubstr(",-1,"));
  const auto before = read_recording(file("ball-bar/r.toml"));
  ASSERT_TRUE(before) << before.error().text();
  write("ball-bar/p.toml", beginning + "readings = [\"p.csv\"]\nunits = { length = \"mm\" }\n[[probe]]\nname = \"" +
                               before->arm.probes.front().name + "\"\nradius = 3\n");
  const auto after = read_recording(file("ball-bar/p.toml"));
  ASSERT_TRUE(after) << after.error().text();
  for (std::size_t i = 0; i < 2; ++i) {
    const Reading& one = before->readings[i];
    const Reading& two = after->readings[i];
    EXPECT_EQ(before->artefacts.name(one.artefact), after->artefacts.name(two.artefact));
    EXPECT_EQ(before->placements.name(one.placement), after->placements.name(two.placement));
    EXPECT_EQ(before->features.name(one.feature), after->features.name(two.feature));
    EXPECT_EQ(before->orientations.name(one.orientation), after->orientations.name(two.orientation));
    EXPECT_EQ(before->repeats.name(one.repeat), after->repeats.name(two.repeat));
  }
  EXPECT_EQ(Json::parse(text_of("p.json"))["points"][1]["feature"], "@SUM");
}

// examples/simulate with the ball bar of examples/certificates, whose numbers stand in a certificate of its own.
TEST_F(Faults, ASimulatedRecordingHasTheCertificatesOfItsArtefacts) {
  take("simulate");
  take("certificates");
  const std::string plan =
      "schema = \"artcal-plan/1\"\narm = \"../simulate/arm.toml\"\nartefacts = [\"bar.toml\"]\nseed = 1\n"
      "units = { length = \"mm\", angle = \"deg\" }\n[noise]\nencoder = \"2 arcsec\"\nprobing = \"3 um\"\n"
      "[[placement]]\nname = \"p\"\nrandom = 5\n[[probing]]\npoints = 15\n";
  write("lab/plan.toml", plan);
  for (const char* certificate : {"certificate.xml", "papers/certificate.xml"}) {
    write(std::string("lab/") + certificate, text_of("certificates/ball-bar-dcc-3.3.0.xml"));
    std::string bar = text_of("certificates/ball-bar-dcc-3.3.0.toml");
    replace_in(bar, "ball-bar-dcc-3.3.0.xml", certificate);
    write("lab/bar.toml", bar);
    const Ended simulated = run({"simulate", "lab/plan.toml", "-o", "out", "--force", "-q"});
    ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
    EXPECT_EQ(text_of("out/certificate.xml"), text_of("certificates/ball-bar-dcc-3.3.0.xml"));
    std::filesystem::rename(file("lab"), file("lab-gone"));
    const Ended identified = run({"identify", "out/recording.toml", "-q", "--no-leave-out"});
    EXPECT_EQ(identified.exit_code, 0) << identified.err;
    std::filesystem::rename(file("lab-gone"), file("lab"));
  }
}

}  // namespace
}  // namespace artcal
