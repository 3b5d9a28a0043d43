#include "fitting/chosen_points.h"

#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace artcal::test {
namespace {

TEST(ChosenPoints, ThoseThatAreTakenAreThoseThatAListOfThemNames) {
  std::mt19937 engine(3);
  for (const int count : {0, 1, 100, 65'536, 200'001}) {
    Eigen::Matrix3Xd points(3, count);
    std::vector<bool> is_taken;
    std::vector<int> taken;
    for (int i = 0; i < count; ++i) {
      points.col(i) << i, -i, 0.5 * i;
      is_taken.push_back(i / 65'536 != 1 && engine() % 3 != 0);  // of the second block none
      if (is_taken.back()) {
        taken.push_back(i);
      }
    }
    const Eigen::Matrix3Xd found = fitting::points_where(points, [&](std::size_t i) { return is_taken[i]; });
    EXPECT_EQ(found, fitting::chosen_points(points, taken)) << count;
  }
}

}  // namespace
}  // namespace artcal::test
