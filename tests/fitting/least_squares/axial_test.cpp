// Cylinders and cones: the starts must lead to the deepest valley, whatever the patch.
#include <gtest/gtest.h>

#include "core/normal_vector.h"
#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

// A patch of a cone (half_angle 0: a cylinder): the arc is about one side, heights about the point.
Eigen::Matrix3Xd patch(double radius, double half_angle, double arc, double length, int across, int along) {
  Eigen::Matrix3Xd points(3, across * along);
  for (int i = 0; i < across * along; ++i) {
    const double turn = arc * ((i % across + 0.5) / across - 0.5);
    const double height = length * ((i / across + 0.5) / along - 0.5);
    points.col(i) = around({12.0, -7.0, 30.0}, radius + height * std::tan(half_angle), turn, height);
  }
  return points;
}

// As a file has it: five decimals.
Eigen::Matrix3Xd rounded(const Eigen::Matrix3Xd& points) { return (points * 1e5).array().round() / 1e5; }

Eigen::Matrix3Xd with_noise_of(Eigen::Matrix3Xd points, double noise, RandomStream& random) {
  for (auto&& p : points.colwise()) {
    p += noise * normal_vector(random);
  }
  return points;
}

template <typename F>
void expect_found(const Eigen::Matrix3Xd& points, const F& truth, double length, double angle) {
  const auto fitted = fit<F>(points);
  ASSERT_TRUE(fitted) << fitted.error().text();
  EXPECT_EQ(fitted->status, FitStatus::Converged);
  const Apart difference = apart(fitted->feature, truth);
  EXPECT_LT(difference.length, length) << difference;
  EXPECT_LT(difference.angle, angle) << difference;
}

TEST(AxialFit, CylinderPatchesOfEveryArc) {
  for (const double degrees : {3.0, 6.0, 15.0, 45.0, 120.0, 270.0, 360.0}) {
    for (const double length : {2.0, 20.0, 300.0}) {
      SCOPED_TRACE(testing::Message() << degrees << "° × " << length);
      const double arc = degrees * pi / 180.0;
      expect_found(patch(25.0, 0.0, arc, length, 9, 5), Cylinder{{12.0, -7.0, 30.0}, a_direction, 25.0},
                   1e-12 / (arc * arc) + 1e-11, 1e-13 / arc + 1e-12);
    }
  }
}

TEST(AxialFit, ConePatchesOfEveryArcAndOpening) {
  for (const double degrees : {6.0, 15.0, 45.0, 120.0, 360.0}) {
    for (const double half_angle : {0.02, 0.2, 0.7, 1.2, 1.45}) {
      SCOPED_TRACE(testing::Message() << degrees << "° opening " << half_angle);
      const double arc = degrees * pi / 180.0;
      const double length = 30.0 * std::cos(half_angle);
      expect_found(patch(25.0, half_angle, arc, length, 9, 5), Cone{{12.0, -7.0, 30.0}, a_direction, 25.0, half_angle},
                   1e-9, 1e-10);
    }
  }
}

TEST(AxialFit, TenMetresFromSevenMillimetresOfSagitta) {
  const double arc = 2.0 * std::acos(1.0 - 7.0 / 10'000.0);
  expect_found(patch(10'000.0, 0.0, arc, 500.0, 9, 5), Cylinder{{12.0, -7.0, 30.0}, a_direction, 10'000.0}, 2e-8,
               1e-11);
  expect_found(patch(10'000.0, 0.3, arc, 500.0, 9, 5), Cone{{12.0, -7.0, 30.0}, a_direction, 10'000.0, 0.3}, 1e-5,
               1e-8);
}

TEST(AxialFit, RoundedFilesConverge) {
  for (const double degrees : {4.0, 10.0, 90.0}) {
    const double arc = degrees * pi / 180.0;
    const auto cylinder = fit<Cylinder>(rounded(patch(25.0, 0.0, arc, 20.0, 9, 5)));
    ASSERT_TRUE(cylinder) << cylinder.error().text();
    EXPECT_EQ(cylinder->status, FitStatus::Converged);
    EXPECT_LT(cylinder->form, 2e-5);
    const auto cone = fit<Cone>(rounded(patch(25.0, 0.3, arc, 20.0, 9, 5)));
    ASSERT_TRUE(cone) << cone.error().text();
    EXPECT_EQ(cone->status, FitStatus::Converged);
    EXPECT_LT(cone->form, 2e-5);
  }
}

TEST(AxialFit, NoStartBeatsTheAnswer) {
  // The valley found is at least as deep as the one at the truth, for many random sets.
  for (std::uint64_t i = 0; i < 40; ++i) {
    const auto points = Shape<Cylinder>::points(12, 0.05, i);
    const auto fitted = fit<Cylinder>(points);
    ASSERT_TRUE(fitted) << fitted.error().text();
    double at_truth = 0.0;
    for (const auto& p : points.colwise()) {
      at_truth += std::pow(signed_distance(Shape<Cylinder>::truth(), p), 2);
    }
    EXPECT_LE(fitted->residuals.squaredNorm(), at_truth);
  }
}

// A patch of any size, arc, opening and noise; the truth's own cost is what a fit has to stay below.
TEST(AxialFit, RandomPatchesEndAtLeastAsDeepAsTheTruth) {
  int refused = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    RandomStream random(19, "patches", i);
    const double radius = std::pow(10.0, random.uniform(-0.5, 4.0));
    const double arc = std::min(2.0 * pi, std::pow(10.0, random.uniform(-1.3, 0.8)));
    const double half_angle = i % 2 == 0 ? 0.0 : random.uniform(0.01, 1.4);
    const double length =
        std::min(radius * std::pow(10.0, random.uniform(-1.5, 1.0)), 1.6 * radius / std::tan(half_angle));
    const double noise =
        radius * (1.0 - std::cos(0.5 * std::min(arc, pi))) * std::pow(10.0, random.uniform(-6.0, -2.0));
    const int count = 9 + static_cast<int>(random.uniform(0.0, 100.0));
    Eigen::Matrix3Xd points(3, count);
    for (auto&& p : points.colwise()) {
      const double height = length * random.uniform(-0.5, 0.5);
      const Eigen::Vector3d off = noise * normal_vector(random);
      p = around({12.0, -7.0, 30.0}, radius + height * std::tan(half_angle), arc * random.uniform(-0.5, 0.5), height) +
          off;
    }
    const auto check = [&](const auto& fitted, const auto& truth) {
      refused += fitted ? 0 : 1;
      double at_truth = 0.0;
      for (const auto& p : points.colwise()) {
        at_truth += std::pow(signed_distance(truth, p), 2);
      }
      if (fitted) {
        EXPECT_EQ(fitted->status, FitStatus::Converged) << i;
        EXPECT_LT(fitted->residuals.squaredNorm(), 1.000001 * at_truth + 1e-20 * radius * radius) << i;
      }
    };
    if (half_angle == 0.0) {
      check(fit<Cylinder>(points), Cylinder{{12.0, -7.0, 30.0}, a_direction, radius});
    } else {
      check(fit<Cone>(points), Cone{{12.0, -7.0, 30.0}, a_direction, radius, half_angle});
    }
  }
  EXPECT_LT(refused, 20);  // short cones of little arc, whose opening the noise hides
}

TEST(AxialFit, DegenerateSetsAreNamed) {
  // One circle; one line; a plane; two parallel lines leave the axis, the radius or both free.
  EXPECT_EQ(fit<Cylinder>(Shape<Circle>::points(20, 0.0)).error().code, ErrorCode::NoSolution);
  EXPECT_EQ(fit<Cylinder>(Shape<Line>::points(20, 0.0)).error().code, ErrorCode::NoSolution);
  EXPECT_EQ(fit<Cylinder>(Shape<Plane>::points(20, 0.0)).error().code, ErrorCode::NoSolution);
  EXPECT_EQ(fit<Cone>(Shape<Plane>::points(20, 0.0)).error().code, ErrorCode::NoSolution);
  EXPECT_EQ(fit<Cone>(Shape<Circle>::points(20, 0.0)).error().code, ErrorCode::NoSolution);
}

TEST(AxialFit, ACylinderIsNoCone) {
  for (const double noise : {0.0, 0.01}) {
    const auto fitted = fit<Cone>(Shape<Cylinder>::points(60, noise));
    ASSERT_FALSE(fitted) << fitted->feature.half_angle;
    EXPECT_EQ(fitted.error().code, ErrorCode::NoSolution);
    EXPECT_NE(fitted.error().message.find("cylinder"), std::string::npos) << fitted.error().message;
  }
}

TEST(AxialFit, APlaneWithNoiseIsNoCylinder) {
  const auto fitted = fit<Cylinder>(Shape<Plane>::points(60, 0.01));
  if (fitted) {
    // Noise can bend a plane by chance; what may not be is a radius that claims to be known.
    const double doubt = std::sqrt((*fitted->covariance)(6, 6));
    EXPECT_GT(doubt, 0.05 * fitted->feature.radius);
  } else {
    EXPECT_EQ(fitted.error().code, ErrorCode::NoSolution);
  }
}

// ---- few rings, and points where a cone has no derivative ----------------------------------------------------

// Rings about the axis at distances from the apex, each turned; the apex itself, some times.
Eigen::Matrix3Xd rings(const std::vector<double>& heights, int on_each, double half_angle, int apexes, double noise,
                       std::uint64_t index) {
  RandomStream random(23, "rings", index);
  const Rigid pose{random.rotation(), {120.0, -340.0, 560.0}};
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(heights.size()) * on_each + apexes);
  Eigen::Index next = 0;
  for (const double height : heights) {
    const double turn = random.uniform(0.0, 6.0);
    for (int i = 0; i < on_each; ++i) {
      const double angle = turn + 2.0 * pi * i / on_each;
      points.col(next++) =
          height * Eigen::Vector3d(std::tan(half_angle) * std::cos(angle), std::tan(half_angle) * std::sin(angle), 1.0);
    }
  }
  points.rightCols(apexes).setZero();
  return with_noise_of(moved(pose, points), noise, random);
}

// Eight points with noise are two more than a cone has unknowns: another one may hold them as well, and is refused.
TEST(AxialFit, ConesOfFewRings) {
  for (const double half_angle : {0.05, 0.3, 0.785, 1.2}) {
    for (const auto& heights : {std::vector{10.0, 30.0}, std::vector{28.0, 30.0}, std::vector{10.0, 20.0, 30.0}}) {
      for (const int on_each : {4, 8, 12}) {
        for (const double noise : {0.0, 0.002}) {
          for (std::uint64_t index = 0; index < 6; ++index) {
            const auto fitted = fit<Cone>(rings(heights, on_each, half_angle, 0, noise, index));
            SCOPED_TRACE(testing::Message() << half_angle << " rad, " << heights.size() << " rings of " << on_each
                                            << " to " << heights.front() << ", noise " << noise);
            if (!fitted && noise > 0.0 && on_each == 4) continue;
            ASSERT_TRUE(fitted) << fitted.error().text();
            EXPECT_NEAR(fitted->feature.half_angle, half_angle, noise == 0.0 ? 1e-9 : 0.01);
          }
        }
      }
    }
  }
}

// The distance to a cone has a kink at its apex: touches there, however many, hide nothing that the others show.
// Steps may go on in the last digits, and the status says so.
TEST(AxialFit, ConesTouchedAtTheirApex) {
  for (const double half_angle : {0.05, 0.3, 0.785, 1.2, 1.4}) {
    for (const int apexes : {1, 5, 20}) {
      for (const double noise : {0.0, 0.005}) {
        for (std::uint64_t index = 0; index < 6; ++index) {
          SCOPED_TRACE(testing::Message() << half_angle << " rad, " << apexes << " at the apex, noise " << noise);
          const auto fitted = fit<Cone>(rings({10.0, 20.0, 30.0}, 12, half_angle, apexes, noise, index));
          ASSERT_TRUE(fitted) << fitted.error().text();
          EXPECT_NEAR(fitted->feature.half_angle, half_angle, noise == 0.0 ? 1e-8 : 0.01);
        }
      }
    }
  }
}

// One ring, or one ring and the apex: to first order the axis may tilt, and noise alone seems to hold it.
TEST(AxialFit, OneRingIsNoCone) {
  for (const double half_angle : {0.05, 0.3, 0.785, 1.2}) {
    for (const double noise : {0.0, 1e-4, 0.01}) {
      for (const int apexes : {0, 1}) {
        for (std::uint64_t index = 0; index < 6; ++index) {
          const auto fitted = fit<Cone>(rings({30.0}, 12, half_angle, apexes, noise, index));
          EXPECT_FALSE(fitted && fitted->status == FitStatus::Converged &&
                       std::abs(fitted->feature.half_angle - half_angle) > 0.05)
              << half_angle << " " << noise << " " << apexes << ": " << (fitted ? fitted->feature.half_angle : 0.0);
          if (apexes == 0) {
            EXPECT_FALSE(fitted) << fitted->feature.half_angle;
          }
        }
      }
    }
  }
}

// A little noise seems to hold a cylinder's axis, though hardly elsewhere than across the ring.
TEST(AxialFit, OneRingIsNoCylinderOfAnotherAxis) {
  for (const double noise : {0.0, 1e-4, 0.01}) {
    for (std::uint64_t index = 0; index < 6; ++index) {
      const Eigen::Matrix3Xd points = rings({30.0}, 12, 0.5, 0, noise, index);
      const auto fitted = fit<Cylinder>(points);
      EXPECT_FALSE(fitted && noise == 0.0);
      if (fitted) {
        const Eigen::Vector3d across =
            (points.col(4) - points.col(0)).cross(points.col(8) - points.col(0)).normalized();
        EXPECT_LT(fitted->feature.direction.cross(across).norm(), 0.02) << noise;
      }
    }
  }
}

TEST(AxialFit, PointsOnTheAxisOfACylinder) {
  Eigen::Matrix3Xd points(3, 42);
  points.leftCols(40) = Shape<Cylinder>::points(40, 0.0);
  points.col(40) = Shape<Cylinder>::truth().point;
  points.col(41) = Shape<Cylinder>::truth().point + 3.0 * a_direction;
  const auto fitted = fit<Cylinder>(points);
  if (fitted) {
    double at_truth = 0.0;
    for (const auto& p : points.colwise()) {
      at_truth += std::pow(signed_distance(Shape<Cylinder>::truth(), p), 2);
    }
    EXPECT_LE(fitted->residuals.squaredNorm(), at_truth);
  }
}

TEST(AxialFit, TheApexOfACone) {
  const Cone truth = Shape<Cone>::truth();
  const auto fitted = fit<Cone>(Shape<Cone>::points(60, 0.0));
  EXPECT_LT((fitted->feature.apex() - truth.apex()).norm(), 1e-11);
  EXPECT_GT(fitted->feature.direction.dot(truth.direction), 0.0);
  EXPECT_NEAR(signed_distance(truth, truth.apex()), 0.0, 1e-12);
}

}  // namespace
}  // namespace artcal::test
