// artcal record: events of an arm become rows, each on disk before it is acknowledged, whatever happens meanwhile.
#include <arpa/inet.h>
#include <pty.h>
#include <sys/socket.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class Record : public testing::ProgramTest {
 protected:
  Record() {
    take("ball-bar");
    write("stream.toml",
          "schema = \"artcal-stream/1\"\nform = \"json\"\njoints = [\"Angle1\", \"Angle2\", \"Angle3\", \"Angle4\", "
          "\"Angle5\", \"Angle6\"]\n"
          "button = \"Buttons\"\nat_rest = { field = \"ArmAtRest\", value = 1 }\n"
          "referenced = { field = \"EncodersReferenced\", value = 1 }\n"
          "no_end_stop = { field = \"EndStops\", value = 0 }\nunits = { joint = \"deg\" }\n");
    std::istringstream table(text_of("ball-bar/readings.csv"));
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
      std::vector<std::string> fields;
      std::istringstream row(line);
      for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
      angles_.emplace_back(fields.end() - 6, fields.end());
    }
  }

  [[nodiscard]] std::string event(std::size_t i, int button = 1, const char* rest = "true", int stops = 0,
                                  const char* referenced = "true") const {
    std::string text = "{";
    for (int j = 0; j < 6; ++j) text += fmt::format("\"Angle{}\":{},", j + 1, angles_[i][static_cast<std::size_t>(j)]);
    return text + fmt::format("\"Buttons\":{},\"ArmAtRest\":{},\"EncodersReferenced\":{},\"EndStops\":{}}}\n", button,
                              rest, referenced, stops);
  }
  [[nodiscard]] std::string touch(std::size_t i) const { return event(i) + event(i, 0); }
  [[nodiscard]] std::vector<std::string> command(const std::string& source, const std::string& folder = "today") const {
    return {
        "record",   "stream.toml", "--arm",  "ball-bar/arm.toml",    "--artefact", "ball-bar/bar.toml", "-o", folder,
        "--source", source,        "--plan", "ball-bar/readings.csv"};
  }
  [[nodiscard]] std::size_t rows(const std::string& table) const {
    const std::string text = text_of(table);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  std::vector<std::vector<std::string>> angles_;
};

TEST_F(Record, WritesARecordingThatIsIdentifiedLikeItsSource) {
  std::string events;
  for (std::size_t i = 0; i < angles_.size(); ++i) events += touch(i);
  write("events.jsonl", events);
  const Ended ended = run(command("events.jsonl"));
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(StartsWith("1 "), HasSubstr("700 readings")));
  ASSERT_EQ(run({"identify", "today/recording.toml", "-o", "a.toml", "--noise", "10 um", "--no-leave-out"}).exit_code,
            0);
  ASSERT_EQ(
      run({"identify", "ball-bar/recording.toml", "-o", "b.toml", "--noise", "10 um", "--no-leave-out"}).exit_code, 0);
  const auto joints = [](const std::string& arm) { return arm.substr(arm.find("[[joint]]"), 200); };
  EXPECT_EQ(joints(text_of("a.toml")), joints(text_of("b.toml")));
}

TEST_F(Record, PassesOverWhatIsNoReadingAndCountsIt) {
  write("events.jsonl", touch(0) + event(1, 1, "false") + event(1, 0) + event(1, 1, "true", 1) + event(1, 0) +
                            event(1, 1, "true", 0, "false") + event(1, 0) + touch(0) + "{\"Angle1\":nul}\n" +
                            event(1).substr(0, 40) + "\n" + "{\"Angle1\":1e999}\n" + touch(2));
  const Ended ended = run(command("events.jsonl"));
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(rows("today/readings.csv"), 3U);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("1: the arm is not at rest"), HasSubstr("1: a joint is at its end stop"),
                               HasSubstr("1: an encoder is not referenced"), HasSubstr("stands where it stood")));
}

TEST_F(Record, ALineWithoutAnEndIsNotKept) {
  write("events.jsonl", touch(0) + std::string(5'000'000, 'x') + "\n" + touch(1));
  const Ended ended = run(command("events.jsonl"));
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(rows("today/readings.csv"), 3U);
  EXPECT_THAT(ended.err, HasSubstr("more than 65536 bytes"));
}

TEST_F(Record, KilledAtAnyMomentItGoesOnWithEveryAcknowledgedReading) {
  std::string events;
  for (std::size_t i = 0; i < 300; ++i) events += touch(i);
  write("events.jsonl", events);
  ASSERT_EQ(run(command("events.jsonl", "whole")).exit_code, 0);
  const std::string whole = text_of("whole/readings.csv");
  const char* asked = std::getenv("ARTCAL_TEST_KILLS");
  const int kills = asked != nullptr ? std::atoi(asked) : 10;
  std::mt19937 random(7);
  for (int k = 0; k < kills; ++k) {
    const pid_t child = start(command("events.jsonl"));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 40'000));
    ::kill(child, SIGKILL);
    const Ended ended = wait_for(child);
    const auto last = ended.out.rfind('\n', ended.out.size() < 2 ? 0 : ended.out.size() - 2);
    const std::string line = last == std::string::npos ? ended.out : ended.out.substr(last + 1);
    const std::string table = std::filesystem::exists(file("today/readings.csv")) ? text_of("today/readings.csv") : "";
    EXPECT_EQ(table, whole.substr(0, table.size())) << "a table is the beginning of the whole";
    if (!line.empty() && std::isdigit(static_cast<unsigned char>(line[0])) != 0 && line.find("reading") == line.npos) {
      EXPECT_GE(rows("today/readings.csv"), 1U + std::stoul(line)) << "acknowledged readings are on disk";
    }
    if (k % 4 == 3) std::filesystem::remove_all(file("today"));
  }
  ASSERT_EQ(run(command("events.jsonl")).exit_code, 0);
  EXPECT_EQ(text_of("today/readings.csv"), whole);
}

TEST_F(Record, TakesEventsFromASerialPort) {
  int master = -1;
  int slave = -1;
  char name[256] = {};
  ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
  const pid_t child = start(command(fmt::format("serial://{}?baud=115200", name)));
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string text = touch(i);
    ASSERT_EQ(::write(master, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  for (int wait = 0;
       wait < 100 && (!std::filesystem::exists(file("today/readings.csv")) || rows("today/readings.csv") < 4); ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  ::kill(child, SIGINT);
  EXPECT_EQ(wait_for(child).exit_code, 0);
  EXPECT_EQ(rows("today/readings.csv"), 4U);
  ::close(master);
  ::close(slave);
}

TEST_F(Record, ComparesCoordinatesWithAngles) {
  std::string stream = text_of("stream.toml");
  write("stream.toml", "xyz = [\"X\", \"Y\", \"Z\"]\n" + stream);
  ASSERT_EQ(run({"points", "ball-bar/recording.toml", "--arm", "ball-bar/arm.toml", "-o", "points.csv"}).exit_code, 0);
  std::istringstream table(text_of("points.csv"));
  std::string line;
  std::getline(table, line);
  std::vector<std::string> names;
  for (std::istringstream row(line); std::getline(row, line, ',');) names.push_back(line);
  const auto column = [&](const std::string& wanted) {
    return std::find(names.begin(), names.end(), wanted) - names.begin();
  };
  std::string sound;
  std::string exchanged;
  for (std::size_t i = 0; i < 6 && std::getline(table, line); ++i) {
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
    const std::string xyz =
        fmt::format("{{\"X\":{},\"Y\":{},\"Z\":{},", fields[column("x")], fields[column("y")], fields[column("z")]);
    const std::string plain = xyz + touch(i).substr(1, touch(i).find('\n')) + event(i, 0).replace(0, 1, xyz);
    sound += plain;
    std::string other = plain;
    for (std::size_t at = 0; (at = other.find("\"Angle", at)) != std::string::npos; ++at) {
      char& number = other[at + 6];
      number = number == '2' ? '3' : number == '3' ? '2' : number;
    }
    exchanged += other;
  }
  write("sound.jsonl", sound);
  EXPECT_EQ(run(command("sound.jsonl", "sound")).err, "");
  write("exchanged.jsonl", exchanged);
  EXPECT_THAT(run(command("exchanged.jsonl", "exchanged")).err, HasSubstr("q2 and q3 exchanged"));
}

}  // namespace
}  // namespace artcal
