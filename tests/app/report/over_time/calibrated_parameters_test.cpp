#include "app/report/over_time/calibrated_parameters.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json result() {
  return Json::parse(R"({
    "parameters": [
      {"name": "a1", "unit": "mm", "state": "weak", "identified": 10, "standard_uncertainty": 0.5, "degrees_of_freedom": 7},
      {"name": "a6", "unit": "mm", "state": "fixed", "identified": 1, "standard_uncertainty": null},
      {"name": "theta6", "unit": "rad", "state": "identified", "identified": 2, "standard_uncertainty": 0.1}],
    "covariance": {"parameters": ["a1", "theta6"], "matrix": [[0.25, 0.01], [0.01, 0.01]]},
    "coupling": {"unidentifiable": [{"motion": {"a6": 1, "theta6": -0.2}}]}})");
}

TEST(CalibratedParameters, AreReadByPlace) {
  const CalibratedParameters read = calibrated_parameters(result());
  ASSERT_EQ(read.parameters.size(), 3u);
  EXPECT_EQ(read.parameters[0].u, 0.5);
  EXPECT_EQ(read.parameters[0].degrees_of_freedom, 7.0);
  EXPECT_EQ(read.parameters[1].u, 0.0);
  EXPECT_TRUE(std::isinf(read.parameters[2].degrees_of_freedom));
  EXPECT_EQ(read.covariance, (Eigen::Matrix2d() << 0.25, 0.01, 0.01, 0.01).finished());
  EXPECT_EQ(read.unidentifiable, Eigen::Vector3d(0.0, 1.0, -0.2));
}

// A covariance in another order would give each parameter the uncertainty of its neighbour.
TEST(CalibratedParameters, OfWhichTheCovarianceIsNotAreRefused) {
  Json other = result();
  other["covariance"]["parameters"] = {"theta6", "a1"};
  EXPECT_THROW(calibrated_parameters(other), std::exception);
  other["covariance"]["parameters"] = {"a1"};
  EXPECT_THROW(calibrated_parameters(other), std::exception);
  other["covariance"]["parameters"] = {"a1", "theta6", "a6"};
  EXPECT_THROW(calibrated_parameters(other), std::exception);
  other = result();
  other["coupling"]["unidentifiable"][0]["motion"]["b6"] = 1;
  EXPECT_THROW(calibrated_parameters(other), std::exception);
}

}  // namespace
}  // namespace artcal
