#include "app/report/over_time/calibrated_parameters.h"

#include <cmath>

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(CalibratedParameters, HaveWhatNoReadingSeesByTheirPlaces) {
  RecordedIdentification result;
  result.parameters = {{"a1", "mm", 9.0, 10.0, ParameterState::Weak, 0.5, 7.0},
                       {"a6", "mm", 1.0, 1.0, ParameterState::Fixed},
                       {"theta6", "rad", 1.9, 2.0, ParameterState::Identified, 0.1}};
  result.covariance = {{"a1", "theta6"}, (Eigen::Matrix2d() << 0.25, 0.01, 0.01, 0.01).finished()};
  result.identifiability.unidentifiable = {{"a6", "", {{"a6", 1.0}, {"theta6", -0.2}}}};
  const CalibratedParameters read = calibrated_parameters(result);
  ASSERT_EQ(read.parameters.size(), 3u);
  EXPECT_EQ(read.parameters[0].value, 10.0);
  EXPECT_EQ(read.parameters[0].u, 0.5);
  EXPECT_EQ(read.parameters[0].degrees_of_freedom, 7.0);
  EXPECT_TRUE(is_identified(read.parameters[0])) << "if only weakly";
  EXPECT_FALSE(is_identified(read.parameters[1]));
  EXPECT_EQ(read.parameters[1].u, 0.0);
  EXPECT_TRUE(std::isinf(read.parameters[2].degrees_of_freedom));
  EXPECT_EQ(read.covariance, result.covariance.matrix);
  EXPECT_EQ(read.unidentifiable, Eigen::Vector3d(0.0, 1.0, -0.2));
}

}  // namespace
}  // namespace artcal
