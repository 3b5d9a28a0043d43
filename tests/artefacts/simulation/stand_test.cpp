#include "artefacts/simulation/stand.h"

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<StandingFeature> bar(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius = 0.0) {
  return {{"A", from, radius}, {"B", to, radius}};
}

TEST(Stand, WithoutLimitsHoldsEverything) { EXPECT_THAT(not_held({}, bar({0, 0, -1e6}, {0, 0, 1e6})), IsEmpty()); }

TEST(Stand, HeightsAreThoseOfTheCentresAndTheFloorIsBelowWholeBalls) {
  Stand stand;
  stand.lowest = -10.0;
  stand.highest = 10.0;
  EXPECT_THAT(not_held(stand, bar({0, 0, -10}, {500, 0, 10}, 15.0)), IsEmpty());
  EXPECT_THAT(not_held(stand, bar({0, 0, -10.5}, {500, 0, 10})),
              HasSubstr("\"A\" is at a height of -10.5 mm, below the lowest"));
  EXPECT_THAT(not_held(stand, bar({0, 0, 0}, {500, 0, 10.5})),
              HasSubstr("\"B\" is at a height of 10.5 mm, above the highest"));
  stand = Stand{};
  stand.floor = 0.0;
  EXPECT_THAT(not_held(stand, bar({0, 0, 15}, {500, 0, 15}, 15.0)), IsEmpty());
  EXPECT_THAT(not_held(stand, bar({0, 0, 14}, {500, 0, 15}, 15.0)),
              HasSubstr("with a radius of 15.0 mm, which reaches below the floor"));
}

TEST(Stand, ATableIsInTheWayOfFeaturesAndOfWhatIsBetweenThem) {
  Stand stand;
  stand.tables.push_back({{100.0, 200.0}, {-50.0, 50.0}, 0.0});
  EXPECT_THAT(not_held(stand, bar({150, 0, 1}, {400, 0, 1})), IsEmpty()) << "on it";
  EXPECT_THAT(not_held(stand, bar({150, 0, -1}, {400, 0, 200})), HasSubstr("goes into the table"));
  EXPECT_THAT(not_held(stand, bar({0, 0, -100}, {300, 0, -100})), HasSubstr("\"A\" and \"B\"")) << "through it";
  EXPECT_THAT(not_held(stand, bar({0, 0, -300}, {0, 0, 300})), IsEmpty()) << "beside it";
  EXPECT_THAT(not_held(stand, bar({0, 0, -100}, {300, 0, 150})), HasSubstr("goes into")) << "through its edge";
  EXPECT_THAT(not_held(stand, bar({0, 0, -10}, {300, 0, 150})), IsEmpty()) << "above its edge";
  EXPECT_THAT(not_held(stand, bar({150, 0, 5}, {150, 0, 200}, 10.0)), HasSubstr("goes into")) << "a ball into its top";
  EXPECT_THAT(not_held(stand, bar({0, 60, -100}, {300, 60, -100}, 5.0)), IsEmpty());
  EXPECT_THAT(not_held(stand, bar({0, 60, -100}, {300, 60, -100}, 15.0)), HasSubstr("goes into")) << "a ball's side";
}

}  // namespace
}  // namespace artcal
