#include "artefacts/verification/decision/specification_file.h"

#include <gmock/gmock.h>

#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using testing::replaced;

const std::string good =
    "schema = \"artcal-specification/1\"\nunits = { length = \"mm\", limit = \"um\" }\nmeasuring_range = 1800\n"
    "[[limit]]\nof = \"P_Size\"\nB = 25\n"
    "[[limit]]\nof = \"E_Uni\"\nA = 20\nK = 50\nB = 35\n"
    "[decision]\nrule = \"iso14253-1:2013\"\n"
    "[temperature]\nlowest_C = 18\nhighest_C = 22\n"
    "[uncertainty]\ntemperature_K = 0.1\nfixture = 1.5\n"
    "[plan]\nlengths = 5\nrepeats = 3\nlongest_share = 0.66\n"
    "[[plan.position]]\nplacement = \"front\"\nfrom = [\"A\", \"A\"]\nto = [\"B\", \"C\"]\n"
    "[outliers]\nsets = 5\nvalues = 1\nagain = 10\n";

class SpecificationFileTest : public ::testing::Test {
 protected:
  Expected<SpecificationFile> read(const std::string& text) {
    return read_specification_file(folder_.write("s.toml", text));
  }
  std::string refusal(const std::string& from, const std::string& to) {
    const auto result = read(replaced(good, from, to));
    return result ? "accepted" : result.error().text();
  }
  testing::TemporaryFolder folder_;
};

TEST_F(SpecificationFileTest, ReadsEverythingIntoMillimetres) {
  const auto file = read(good);
  ASSERT_TRUE(file) << file.error().text();
  const Specification& by = file->specification;
  EXPECT_DOUBLE_EQ(by.limits.at(Quantity::SizeError).at(1000.0), 0.025);
  EXPECT_DOUBLE_EQ(by.limits.at(Quantity::LengthUni).at(500.0), 0.030);  // 20 um + 500/50 um
  EXPECT_DOUBLE_EQ(by.limits.at(Quantity::LengthUni).at(1000.0), 0.035);
  EXPECT_EQ(by.rule, DecisionRule::Iso14253_2013);
  EXPECT_EQ(by.measuring_range, 1800.0);
  EXPECT_EQ(by.u_temperature, 0.1);
  EXPECT_DOUBLE_EQ(by.u_fixture, 0.0015);
  ASSERT_TRUE(by.plan);
  EXPECT_EQ(by.plan->lengths, 5);
  ASSERT_EQ(by.plan->named.size(), 1u);
  EXPECT_EQ(by.plan->named[0].lengths[1], (std::pair<std::string, std::string>{"A", "C"}));
  EXPECT_EQ(by.outliers.again, 10);
}

TEST_F(SpecificationFileTest, WaivesEvidenceByName) {
  EXPECT_TRUE(read(good)->specification.waived.empty());
  const auto file = read("waive = [\"certificate_lapsed\", \"date_absent\"]\n" + good);
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_EQ(file->specification.waived, (std::set{Evidence::CertificateLapsed, Evidence::DateAbsent}));
  const auto unknown = read("waive = [\"certificates\"]\n" + good);
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().text(), HasSubstr("`waive` names \"certificates\", expected certificate_absent"));
}

TEST_F(SpecificationFileTest, RefusesWhatMeansNothing) {
  EXPECT_THAT(refusal("B = 25", "A = 25"), HasSubstr("A and K belong together"));
  EXPECT_THAT(refusal("B = 25", "B = -25"), HasSubstr("s.toml:6:5: `B` is -25, expected a number above zero"));
  EXPECT_THAT(refusal("K = 50", "K = 0"), HasSubstr("`K` is 0, expected a number above zero"));
  EXPECT_THAT(refusal("P_Size", "P_Siz"), HasSubstr("the limit is of \"P_Siz\", expected P_Size"));
  EXPECT_THAT(refusal("P_Size", "E_Uni"), HasSubstr("the limit of E_Uni is stated twice"));
  EXPECT_THAT(refusal("iso14253-1:2013", "iso"), HasSubstr("the decision rule is \"iso\""));
  EXPECT_THAT(refusal("lowest_C = 18", "lowest_C = 28"), HasSubstr("the lowest temperature is above the highest"));
  EXPECT_THAT(refusal("lengths = 5", "lengths = 5.5"), HasSubstr("expected a whole number"));
  EXPECT_THAT(refusal("to = [\"B\", \"C\"]", "to = [\"B\"]"), HasSubstr("they make pairs"));
  EXPECT_THAT(refusal("limit = \"um\"", "limit = \"micron\""), HasSubstr("micron"));
  EXPECT_THAT(refusal("sets = 5", "set = 5"), HasSubstr("set"));
}

}  // namespace
}  // namespace artcal
