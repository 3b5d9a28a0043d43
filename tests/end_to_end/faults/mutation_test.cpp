// Files that were damaged at random: whatever they hold, the program ends by itself with an exit code that
// says how, and with one line where it fails.
#include <gmock/gmock.h>

#include "core/random.h"
#include "tests/end_to_end/program.h"
#include "tests/support/damage.h"

namespace artcal {
namespace {

using testing::damaged;
using testing::Ended;

class Mutation : public testing::ProgramTest {
 protected:
  using Commands = std::vector<std::vector<std::string>>;

  // Runs the commands in turn, each on a file of its own damage.
  void damage(const std::string& example, const std::string& name, int times, const Commands& commands) {
    take(example);
    const std::string path = example + "/" + name;
    const std::string good = text_of(path);
    std::array<int, 5> ends{};
    for (int i = 0; i < times; ++i) {
      RandomStream random(2026, path, static_cast<std::uint64_t>(i));
      const std::string bad = damaged(good, random);
      write(path, bad);
      const Ended ended = run(commands[static_cast<std::size_t>(i) % commands.size()]);
      if (ended.exit_code < 0 || ended.exit_code > 4) {
        ADD_FAILURE() << path << ", mutation " << i << ": exit code " << ended.exit_code << ", signal " << ended.signal
                      << "\n"
                      << ended.err;
        continue;
      }
      ++ends[static_cast<std::size_t>(ended.exit_code)];
      const auto lines = std::count(ended.err.begin(), ended.err.end(), '\n');
      EXPECT_EQ(lines, ended.exit_code <= 1 ? 0 : 1) << path << ", mutation " << i << "\n" << ended.err;
      EXPECT_LT(ended.err.size(), 1000u) << path << ", mutation " << i;
      EXPECT_EQ(ended.err.find("internal error"), std::string::npos) << path << ", mutation " << i << "\n" << ended.err;
    }
    EXPECT_TRUE(ends[1] == 0 || commands.front().front() == "verify") << path << ": nothing else fails a verification";
    EXPECT_GT(ends[3], times / 4) << path << ": damages that do nothing test nothing";
  }
  void damage(const std::string& example, const std::string& name, int times) {
    const std::vector<std::string> identify{"identify", example + "/recording.toml", "--json", "-", "--no-leave-out"};
    damage(example, name, times,
           {identify, identify, identify, {"coupling", example + "/recording.toml", "--json", "-"}});
  }
  void damage_verified(const std::string& example, const std::string& name, int times) {
    const auto verify = [&](const char* standard) {
      return std::vector<std::string>{"verify", example + "/recording.toml", "--standard", standard, "--json", "-"};
    };
    damage(example, name, times, {verify("iso10360-12"), verify("sphere-plate"), verify("b89.4.22")});
  }
};

constexpr int times = 200;
constexpr int verified_times = 90;

TEST_F(Mutation, OfThePandasArm) { damage("two-socket-bar", "arm.toml", times); }
TEST_F(Mutation, OfThePandasBar) { damage("two-socket-bar", "bar.toml", times); }
TEST_F(Mutation, OfThePandasRecording) { damage("two-socket-bar", "recording.toml", times); }
TEST_F(Mutation, OfThePandasReadings) { damage("two-socket-bar", "readings.csv", times); }
TEST_F(Mutation, OfTheSimulatedArm) { damage("ball-bar", "arm.toml", times); }
TEST_F(Mutation, OfTheBallBar) { damage("ball-bar", "bar.toml", times); }
TEST_F(Mutation, OfTheBallBarsRecording) { damage("ball-bar", "recording.toml", times); }
TEST_F(Mutation, OfTheBallBarsReadings) { damage("ball-bar", "readings.csv", times); }
TEST_F(Mutation, OfThePapersArm) { damage("gao2013", "table1.toml", times); }
TEST_F(Mutation, OfThePapersReadings) { damage("gao2013", "readings.csv", times); }

TEST_F(Mutation, OfAVerifiedRecording) { damage_verified("iso10360-12", "recording.toml", verified_times); }
TEST_F(Mutation, OfAVerifiedRecordingsReadings) { damage_verified("iso10360-12", "readings.csv", verified_times); }
TEST_F(Mutation, OfAVerifiedArm) { damage_verified("iso10360-12", "arm.toml", verified_times); }
TEST_F(Mutation, OfTheVerifyingBar) { damage_verified("iso10360-12", "bar.toml", verified_times); }
TEST_F(Mutation, OfTheSpecification) { damage_verified("iso10360-12", "specification.toml", verified_times); }
TEST_F(Mutation, OfTheSpherePlate) { damage_verified("sphere-plate", "plate.toml", verified_times); }
TEST_F(Mutation, OfTheSpherePlatesReadings) { damage_verified("sphere-plate", "readings.csv", verified_times); }

}  // namespace
}  // namespace artcal
