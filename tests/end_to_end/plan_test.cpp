// `artcal plan`: what it takes, writes and refuses.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;

class PlanCommand : public testing::ProgramTest {
 protected:
  void SetUp() override { take("ball-bar"); }
  Ended plan(std::vector<std::string> more) {
    std::vector<std::string> words{
        "plan", "ball-bar/arm.toml", "--artefact", "ball-bar/bar.toml", "--possible", "8",           "--postures",
        "8",    "--readings",        "6",          "--encoder-noise",   "2 arcsec",   "--placements"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

TEST_F(PlanCommand, WritesATableAndAPicture) {
  const Ended ended = plan({"3", "--probing-noise", "3 um", "-o", "plan.csv", "--picture", "plan.svg"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("3 of 8 possible placements"), HasSubstr("with this plan")));
  const std::string table = text_of("plan.csv");
  EXPECT_THAT(table, StartsWith("placement,artefact,feature,q1,q2,q3,q4,q5,q6\n"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 3 * 4 * 6);  // four balls
  EXPECT_THAT(text_of("plan.svg"), AllOf(StartsWith("<svg "), HasSubstr("<title>"), HasSubstr("</svg>")));
}

TEST_F(PlanCommand, SaysTheSameEveryTime) {
  const auto json = [&] { return plan({"2", "--probing-noise", "3 um", "--json", "-"}).out; };
  const std::string first = json();
  EXPECT_EQ(first, json());
  EXPECT_EQ(Json::parse(first)["chosen"].size(), 2u);
}

TEST_F(PlanCommand, RefusesWhatMakesNoPlan) {
  const Ended many = plan({"9", "--probing-noise", "3 um"});
  EXPECT_EQ(many.exit_code, 2);
  EXPECT_THAT(many.err, HasSubstr("9 placements are to be chosen, but only 8 are possible"));
  const Ended zero = plan({"2", "--probing-noise", "0 um"});
  EXPECT_EQ(zero.exit_code, 2);
  EXPECT_THAT(zero.err, HasSubstr("--probing-noise is \"0 um\", expected a number above zero"));
  const Ended bare = run({"plan", "ball-bar/arm.toml", "--encoder-noise", "2 arcsec", "--probing-noise", "3 um"});
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_THAT(bare.err, HasSubstr("--artefact artefact.toml"));
  const Ended other = plan({"2", "--probing-noise", "3 um", "--measured", "ball-bar/bar.toml"});
  EXPECT_EQ(other.exit_code, 3);
  const Ended over = plan({"2", "--probing-noise", "3 um", "-o", "ball-bar/arm.toml"});
  EXPECT_NE(over.exit_code, 0);
}

}  // namespace
}  // namespace artcal
