#include "core/coincidence/coincident_columns.h"

#include <cmath>
#include <map>
#include <random>
#include <vector>

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(CoincidentColumns, FirstOfTheSame) {
  Eigen::MatrixXd columns(2, 6);
  columns << 1, 2, 1, NAN, -0.0, NAN, 0, 0, 0, 5, 0, 5;
  EXPECT_THAT(first_coincident(columns), ElementsAre(0, 1, 0, 3, 4, 3));
  columns(0, 1) = 0.0;
  EXPECT_THAT(first_coincident(columns), ElementsAre(0, 1, 0, 3, 1, 3));
  columns(1, 3) = -columns(1, 5);
  columns(0, 3) = -NAN;
  EXPECT_THAT(first_coincident(columns), ElementsAre(0, 1, 0, 3, 1, 5));
  EXPECT_THAT(first_coincident(Eigen::MatrixXd(3, 0)), IsEmpty());
  EXPECT_THAT(first_coincident(Eigen::MatrixXd(0, 3)), ElementsAre(0, 0, 0));
}

TEST(CoincidentColumns, AreThoseOfAMap) {
  std::mt19937 random(5);
  for (const auto& [count, values] : std::vector<std::pair<Eigen::Index, unsigned>>{
           {1, 1}, {2, 1}, {1000, 1}, {1000, 6}, {5000, 40}, {300'000, 60}, {300'000, 1000}}) {
    Eigen::Matrix3Xd columns(3, count);
    for (double& value : columns.reshaped()) {
      value = 0.1 * (static_cast<double>(random() % values) - 3.0);
    }
    std::map<std::vector<double>, Eigen::Index> known;
    std::vector<std::pair<Eigen::Index, Eigen::Index>> expected;
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto [at, is_new] = known.insert({{columns(0, i), columns(1, i), columns(2, i)}, i});
      if (!is_new) {
        expected.emplace_back(i, at->second);
      }
    }
    for (const int threads : {0, 1, 2, 5}) {
      std::vector<std::pair<Eigen::Index, Eigen::Index>> found;
      for (const auto& [column, first] : repeated_columns(columns, threads)) {
        found.emplace_back(column, first);
      }
      ASSERT_TRUE(found == expected) << count << " columns of " << values << " values, " << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace artcal
