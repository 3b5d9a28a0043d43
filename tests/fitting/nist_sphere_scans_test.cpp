// Real scans with published rows and answers (tests/reference/nist-sphere-scans), from the file to the sphere.

#include <cstdio>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "acquisition/point_cloud/point_cloud.h"
#include "core/units.h"
#include "fitting/fit.h"

namespace artcal {
namespace {

const std::filesystem::path folder = std::filesystem::path(ARTCAL_SOURCE_DIR) / "tests/reference/nist-sphere-scans";

Eigen::Vector3d centre_of(const nlohmann::json& answer) {
  Eigen::Vector3d centre;
  for (int axis = 0; axis < 3; ++axis) {
    centre[axis] = std::stod(answer["center"][static_cast<std::size_t>(axis)].get<std::string>());
  }
  return centre;
}

class SphereScan : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    expected_ = nlohmann::json::parse(std::ifstream(folder / "expected.json"))["results"][GetParam()];
    auto cloud = read_point_cloud(folder / (GetParam() + ".xyz"), {units::metre, {}});
    ASSERT_TRUE(cloud) << cloud.error().text();
    EXPECT_THAT(cloud->warnings, ::testing::IsEmpty());
    const auto kept = expected_["kept_rows"].get<std::vector<Eigen::Index>>();
    points_ = cloud->points(Eigen::all, kept);
  }
  nlohmann::json expected_;
  Eigen::Matrix3Xd points_;
};

// Nine decimals of a metre are what the answers are good for, a millionth of a millimetre.
constexpr double bound = 1e-9 * units::metre;

TEST_P(SphereScan, FixedRadiusCentreOfTheListedRows) {
  FitOptions options;
  options.fixed_radius = 50.0;
  const auto fitted = fit<Sphere>(points_, options);
  ASSERT_TRUE(fitted) << fitted.error().text();
  const auto& answer = expected_["fixed_radius"];
  const double off = (fitted->feature.centre - units::metre * centre_of(answer)).norm();
  std::printf("%s fixed radius: %d points, centre off by %.1e mm\n", GetParam().c_str(),
              static_cast<int>(points_.cols()), off);
  EXPECT_LT(off, bound);
  EXPECT_NEAR(fitted->rms, units::metre * answer["rms"].get<double>(), bound);
}

TEST_P(SphereScan, FreeRadiusOfTheListedRows) {
  const auto fitted = fit<Sphere>(points_);
  ASSERT_TRUE(fitted) << fitted.error().text();
  const auto& answer = expected_["free_radius"];
  EXPECT_LT((fitted->feature.centre - units::metre * centre_of(answer)).norm(), bound);
  EXPECT_NEAR(fitted->feature.radius, units::metre * std::stod(answer["radius"].get<std::string>()), bound);
  EXPECT_NEAR(fitted->rms, units::metre * answer["rms"].get<double>(), bound);
}

INSTANTIATE_TEST_SUITE_P(Nist, SphereScan,
                         ::testing::Values("SPH101", "SPH103", "SPH104", "SPH105", "SPH106", "SPH107"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace artcal
