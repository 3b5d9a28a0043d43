// artcal record: events of an arm become rows, each on disk before it is acknowledged, whatever happens meanwhile.
#include <arpa/inet.h>
#include <pty.h>
#include <sys/socket.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <random>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"
#include "tests/support/sanitizers/sanitized.h"

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
  // Until as many rows are there, ten seconds at most.
  void wait_for_rows(std::size_t count) const {
    for (int wait = 0; wait < 200 && rows("today/readings.csv") < count; ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }
  static bool send_all(int to, const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t sent = ::write(to, text.data() + done, text.size() - done);
      if (sent <= 0) return false;
      done += static_cast<std::size_t>(sent);
    }
    return true;
  }
  [[nodiscard]] std::string touches(std::size_t count) const {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += touch(i);
    return all;
  }
  [[nodiscard]] std::size_t rows(const std::string& table) const {
    const std::string text = std::filesystem::exists(file(table)) ? text_of(table) : "";
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  std::vector<std::vector<std::string>> angles_;
};

// A socket of the loopback address and its port; bound, not yet listening.
std::pair<int, int> bound_socket() {
  const int bound = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  EXPECT_EQ(::bind(bound, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(::getsockname(bound, reinterpret_cast<sockaddr*>(&address), &size), 0);
  return {bound, ntohs(address.sin_port)};
}

TEST_F(Record, EndsWithTheBytesThatIdentifyWritesOfItsRecording) {
  write("events.jsonl", touches(angles_.size()));
  auto recorded = command("events.jsonl");
  for (const char* more : {"--identified", "recorded.toml", "--result", "recorded.json"}) recorded.emplace_back(more);
  const Ended ended = run(recorded);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(StartsWith("1 "), HasSubstr("700 readings in today/readings.csv")));
  const Ended again = run({"identify", "today/recording.toml", "-o", "again.toml", "--json", "again.json"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(text_of("recorded.toml"), text_of("again.toml"));
  auto first = nlohmann::ordered_json::parse(text_of("recorded.json"));
  auto second = nlohmann::ordered_json::parse(text_of("again.json"));
  first.erase("timings_s");
  second.erase("timings_s");
  EXPECT_EQ(first.dump(), second.dump());
  const std::string text = again.out.substr(0, again.out.rfind("The identified arm"));
  EXPECT_THAT(ended.out, HasSubstr(text));
}

TEST_F(Record, TheRecordingStandsByItself) {
  write("events.jsonl", touches(3));
  ASSERT_EQ(run(command("events.jsonl")).exit_code, 0);
  EXPECT_EQ(text_of("today/arm.toml"), text_of("ball-bar/arm.toml"));
  EXPECT_EQ(text_of("today/bar.toml"), text_of("ball-bar/bar.toml"));
  write("ball-bar/bar.toml", text_of("ball-bar/bar.toml") + "# other\n");
  const Ended ended = run(command("events.jsonl"));
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("begun with another file"));
  EXPECT_EQ(rows("today/readings.csv"), 4U);
}

TEST_F(Record, PassesOverWhatIsNoReadingAndCountsIt) {
  write("events.jsonl", touch(0) + event(1, 1, "false") + event(1, 0) + event(1, 1, "true", 1) + event(1, 0) +
                            event(1, 1, "true", 0, "false") + event(1, 0) + touch(0) + "{\"Angle1\":NaN}\n" +
                            event(1).substr(0, 40) + "\n" + "{\"Angle1\":1e999}\n" + touch(2));
  const Ended ended = run(command("events.jsonl"));
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(rows("today/readings.csv"), 3U);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("passed over 1: the arm is not at rest"),
                               HasSubstr("passed over 1: a joint is at its end stop"),
                               HasSubstr("passed over 1: an encoder is not referenced"),
                               HasSubstr("passed over 1: the arm stands where it stood")));
  EXPECT_THAT(ended.err, HasSubstr("not at rest"));
}

TEST_F(Record, LabelsComeFromTheLinesOfAPerson) {
  write("events.jsonl", touch(0) + touch(1) + "!undo\n" + touch(2) + "!next feature\n" + touch(3) +
                            "!next placement\n" + touch(4) + "!feature 3\n" + touch(5) + "!feature 7\n!sing\n");
  const Ended ended = run({"record", "stream.toml", "--arm", "ball-bar/arm.toml", "--artefact", "ball-bar/bar.toml",
                           "-o", "today", "--source", "events.jsonl"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  std::istringstream table(text_of("today/readings.csv"));
  std::vector<std::string> labels;
  std::string header;
  std::getline(table, header);
  EXPECT_THAT(header, StartsWith("artefact,placement,feature,q1,"));
  for (std::string line; std::getline(table, line);)
    labels.push_back(line.substr(0, line.find(',', line.rfind('"') + 5)));
  EXPECT_THAT(labels, ::testing::ElementsAre("\"ball bar 1000\",1,0", "\"ball bar 1000\",1,0", "\"ball bar 1000\",1,1",
                                             "\"ball bar 1000\",2,0", "\"ball bar 1000\",2,3"));
  EXPECT_THAT(ended.err, AllOf(HasSubstr("no feature of the readings to come is called \"7\""),
                               HasSubstr("lines with ! that are not understood")));
}

// A gigabyte without a line end: the file has a hole, which reads as zeros.
TEST_F(Record, ALineWithoutAnEndIsNotKept) {
  if (testing::is_sanitized) {
    GTEST_SKIP() << "a sanitizer takes more addresses than the limit";
  }
  write("events.jsonl", touch(0));
  std::filesystem::resize_file(file("events.jsonl"), std::size_t{1} << 30);
  std::ofstream(file("events.jsonl"), std::ios::binary | std::ios::app) << "\n" << touch(1);
  std::vector<std::string> limited{"sh", "-c", "ulimit -v 700000; exec \"$@\"", "sh", ARTCAL_PROGRAM};
  for (const std::string& argument : command("events.jsonl")) limited.push_back(argument);
  const Ended ended = run_command(limited);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(rows("today/readings.csv"), 3U);
  EXPECT_THAT(ended.err, HasSubstr("more than 65536 bytes"));
}

TEST_F(Record, KilledAtAnyMomentItGoesOnWithEveryAcknowledgedReading) {
  write("events.jsonl", touches(300));
  ASSERT_EQ(run(command("events.jsonl", "whole")).exit_code, 0);
  const std::string whole = text_of("whole/readings.csv");
  std::mt19937 random(7);
  std::size_t in_the_middle = 0;
  const auto before_start = std::chrono::steady_clock::now();
  ASSERT_EQ(run({"--version"}).exit_code, 0);
  const auto start_takes =
      std::chrono::ceil<std::chrono::microseconds>(std::chrono::steady_clock::now() - before_start);
  const auto latest = 2 * start_takes.count() + 50'000;
  for (int k = 0; k < 50; ++k) {
    const pid_t child = start(command("events.jsonl"));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % latest));
    ::kill(child, SIGKILL);
    const Ended ended = wait_for(child);
    const auto last = ended.out.rfind('\n', ended.out.size() < 2 ? 0 : ended.out.size() - 2);
    const std::string line = last == std::string::npos ? ended.out : ended.out.substr(last + 1);
    const std::string table = text_of("today/readings.csv");
    EXPECT_EQ(table, whole.substr(0, table.size())) << "a table is the beginning of the whole";
    if (!line.empty() && std::isdigit(static_cast<unsigned char>(line[0])) != 0 && line.find("reading") == line.npos) {
      EXPECT_GE(rows("today/readings.csv"), 1U + std::stoul(line)) << "acknowledged readings are on disk";
    }
    in_the_middle += !table.empty() && table.size() < whole.size() ? 1U : 0U;
    if (k % 4 == 3) std::filesystem::remove_all(file("today"));
  }
  EXPECT_GT(in_the_middle, 5U);
  ASSERT_EQ(run(command("events.jsonl")).exit_code, 0);
  EXPECT_EQ(text_of("today/readings.csv"), whole);
}

TEST_F(Record, TakesEventsFromASerialPort) {
  int master = -1;
  int slave = -1;
  char name[256] = {};
  ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
  const pid_t child = start(command(fmt::format("serial://{}?baud=115200", name)));
  wait_for_rows(1);  // the port is open before the table is
  ASSERT_TRUE(send_all(master, touches(3)));
  wait_for_rows(2);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  for (std::size_t i = 3; i < 6; ++i) {
    ASSERT_TRUE(send_all(master, touch(i)));
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
  }
  wait_for_rows(5);
  ::kill(child, SIGINT);
  EXPECT_EQ(wait_for(child).exit_code, 0);
  EXPECT_GE(rows("today/readings.csv"), 5U);
  ::close(master);
  ::close(slave);
}

TEST_F(Record, ThinsAFloodThatComesByTheNetwork) {
  const auto [unused, port] = bound_socket();
  ::close(unused);
  const pid_t child = start(command(fmt::format("listen://{}", port)));
  wait_for_rows(1);
  const int device = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ASSERT_EQ(::connect(device, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  for (int k = 0; k < 20; ++k) ASSERT_TRUE(send_all(device, touches(500)));
  ::close(device);
  const Ended ended = wait_for(child);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("thinned: more than 20 readings a second"));
  EXPECT_THAT(rows("today/readings.csv"), AllOf(::testing::Ge(2U), ::testing::Le(300U)));
}

TEST_F(Record, ConnectsToAProgramThatSendsLines) {
  const auto [server, port] = bound_socket();
  ASSERT_EQ(::listen(server, 1), 0);
  const pid_t child = start(command(fmt::format("tcp://127.0.0.1:{}", port)));
  const int connection = ::accept(server, nullptr, nullptr);
  ASSERT_TRUE(send_all(connection, touch(0)));
  wait_for_rows(2);
  ::close(connection);
  EXPECT_EQ(wait_for(child).exit_code, 0);
  EXPECT_EQ(rows("today/readings.csv"), 2U);
  ::close(server);
}

TEST_F(Record, FollowsAFileAndTheKeysOfATerminal) {
  int master = -1;
  int slave = -1;
  char name[256] = {};
  ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
  write("events.jsonl", touch(0));
  std::vector<std::string> typed{"sh",
                                 "-c",
                                 fmt::format("exec \"$@\" < {}", name),
                                 "sh",
                                 ARTCAL_PROGRAM,
                                 "record",
                                 "stream.toml",
                                 "--arm",
                                 "ball-bar/arm.toml",
                                 "--artefact",
                                 "ball-bar/bar.toml",
                                 "-o",
                                 "today",
                                 "--source",
                                 "events.jsonl",
                                 "--follow"};
  const pid_t child = start_command(typed);
  const auto append = [&](std::size_t i, std::size_t rows_then) {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    std::ofstream(file("events.jsonl"), std::ios::binary | std::ios::app) << touch(i);
    wait_for_rows(rows_then);
  };
  const auto press = [&](const char* key) {
    ASSERT_TRUE(send_all(master, key));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
  };
  wait_for_rows(2);
  append(1, 3);
  press("u");
  EXPECT_EQ(rows("today/readings.csv"), 2U);
  press("n");
  append(2, 3);
  press("p");
  append(3, 4);
  press("q");
  EXPECT_EQ(wait_for(child).exit_code, 0);
  EXPECT_THAT(text_of("today/readings.csv"),
              AllOf(HasSubstr("\"ball bar 1000\",1,0,"), HasSubstr("\"ball bar 1000\",1,1,"),
                    HasSubstr("\"ball bar 1000\",2,0,")));
  EXPECT_EQ(rows("today/readings.csv"), 4U);
  ::close(master);
  ::close(slave);
}

TEST_F(Record, RefusesWhatCannotBecomeARecording) {
  write("events.jsonl", touch(0));
  auto other = command("events.jsonl");
  other[3] = "two-socket-bar/arm.toml";
  take("two-socket-bar");
  EXPECT_THAT(run(other).err, HasSubstr("the stream has 6 joints, the arm \"Franka Emika Panda\" has 7"));
  EXPECT_THAT(run(command("tcp://nowhere")).err, HasSubstr("expected tcp://HOST:PORT"));
  EXPECT_THAT(run(command("missing.jsonl")).err, HasSubstr("cannot be opened: No such file"));
  EXPECT_THAT(run(command("ball-bar")).err, HasSubstr("it is a folder"));
  EXPECT_THAT(run(command("events.jsonl", "ball-bar")).err, HasSubstr("begins with other columns"));
  EXPECT_FALSE(std::filesystem::exists(file("today")));
  auto labels = command("events.jsonl");
  labels.back() = "plan.csv";
  write("plan.csv", "placement,feature\n1,9\n");
  EXPECT_THAT(run(labels).err,
              HasSubstr("plan.csv:2:3: the plan names the feature \"9\", expected one of the artefact"));
  write("plan.csv", "artefact,placement,feature\nbar,1,1\n");
  EXPECT_THAT(run(labels).err,
              HasSubstr("plan.csv:2:1: the plan names the artefact \"bar\", expected one of --artefact"));
}

}  // namespace
}  // namespace artcal
