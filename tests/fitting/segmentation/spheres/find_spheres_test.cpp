#include "fitting/segmentation/spheres/find_spheres.h"
#include "core/normal_vector.h"

#include <functional>
#include <numeric>
#include <set>

#include <gmock/gmock.h>

#include "tests/support/scans.h"

namespace artcal::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const FoundSphere* near(const SphereSearchResult& result, const Eigen::Vector3d& centre) {
  for (const FoundSphere& sphere : result.spheres) {
    if ((sphere.fitted.feature.centre - centre).norm() < 0.1 * sphere.radius_wanted) return &sphere;
  }
  return nullptr;
}

SphereSearchResult found_in(const SimulatedScan& scan, double radius) {
  return find_spheres(scan.points, {{radius}}).value();
}

// Points spread evenly over the cap of a sphere about +z, up to an angle from there.
Eigen::Matrix3Xd cap(const Eigen::Vector3d& centre, double radius, double angle, int count, double noise = 0.0) {
  RandomStream random(5, "cap");
  Eigen::Matrix3Xd points(3, count);
  for (int i = 0; i < count; ++i) {
    const double z = random.uniform(std::cos(angle), 1.0);
    const double turn = random.uniform(0.0, 6.283185307179586);
    const double across = std::sqrt(1.0 - z * z);
    points.col(i) = centre + (radius + noise * random.normal()) *
                                 Eigen::Vector3d(across * std::cos(turn), across * std::sin(turn), z);
  }
  return points;
}

// ---- against the best that can be done ----------------------------------------------------------------------

struct Case {
  const char* name;
  ScanSettings settings;
  int seeds = 4;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

ScanSettings bar(double radius, double noise, double spacing, double ball_spacing) {
  ScanSettings s;
  s.radius = radius;
  s.centres = ball_bar({0.0, 16.0 * radius, 25.0 * radius});
  s.noise = noise;
  s.spacing = spacing;
  s.ball_spacing = ball_spacing;
  return s;
}

ScanSettings plate() {
  ScanSettings s = bar(12.7, 0.02, 2.0, 0.8);
  s.centres = sphere_plate(5, 5, 80.0);
  return s;
}

ScanSettings ten_metres_away() {
  ScanSettings s = bar(12.7, 0.02, 1.5, 0.6);
  s.offset = {10'000.0, -10'000.0, 10'000.0};
  return s;
}

ScanSettings from_three_sides() {
  ScanSettings s = bar(12.7, 0.02, 2.0, 0.8);
  s.views = 3;
  return s;
}

class LeastSquaresLimit : public ::testing::TestWithParam<Case> {};

// Over all balls and seeds the centres are as good as if someone had told which points are whose.
TEST_P(LeastSquaresLimit, IsReached) {
  double ours = 0.0;
  double limit = 0.0;
  long wrong = 0, own = 0, there = 0;
  for (int seed = 1; seed <= GetParam().seeds; ++seed) {
    ScanSettings settings = GetParam().settings;
    settings.seed = static_cast<std::uint64_t>(seed);
    const SimulatedScan scan = simulate_scan(settings);
    const SphereSearchResult result = found_in(scan, settings.radius);
    EXPECT_THAT(result.spheres, SizeIs(scan.centres.size()));
    for (int ball = 0; ball < static_cast<int>(scan.centres.size()); ++ball) {
      const Eigen::Vector3d& truth = scan.centres[static_cast<std::size_t>(ball)];
      const FoundSphere* sphere = near(result, truth);
      ASSERT_NE(sphere, nullptr) << "ball " << ball << ", seed " << seed;
      ours += (sphere->fitted.feature.centre - truth).squaredNorm();
      limit += (least_squares_limit(scan, ball, truth, settings.radius) - truth).squaredNorm();
      for (const int i : sphere->points) {
        (scan.labels[static_cast<std::size_t>(i)] == ball ? own : wrong) += 1;
      }
      there += static_cast<long>(scan.points_on(ball).size());
    }
  }
  EXPECT_LE(std::sqrt(ours), 1.10 * std::sqrt(limit)) << std::sqrt(ours / limit);
  EXPECT_LE(wrong, 0.01 * static_cast<double>(own));
  EXPECT_GE(own, 0.97 * static_cast<double>(there));
  RecordProperty("ratio", std::to_string(std::sqrt(ours / limit)));
}

INSTANTIATE_TEST_SUITE_P(
    Scans, LeastSquaresLimit,
    ::testing::Values(Case{"Bar", bar(12.7, 0.02, 1.5, 0.6)}, Case{"BarDense", bar(12.7, 0.02, 1.5, 0.25), 2},
                      Case{"BarSparse", bar(12.7, 0.02, 2.5, 0.0), 8}, Case{"BarNoisy", bar(12.7, 0.1, 1.5, 0.6)},
                      Case{"BarQuiet", bar(12.7, 0.003, 1.5, 0.6)}, Case{"LargeBalls", bar(50.0, 0.1, 6.0, 2.5)},
                      Case{"SmallBalls", bar(2.5, 0.01, 0.3, 0.12)}, Case{"TenMetresAway", ten_metres_away()},
                      Case{"FromThreeSides", from_three_sides()}, Case{"Plate", plate(), 1}),
    [](const auto& test) { return std::string(test.param.name); });

// ---- what is none of the ball's ------------------------------------------------------------------------------

TEST(FindSpheres, StemsDoNotPull) {
  ScanSettings settings = bar(12.7, 0.1, 1.2, 0.3);
  settings.missing = 0.0;
  settings.mixed = 0.0;
  settings.views = 3;
  const SimulatedScan scan = simulate_scan(settings);
  const auto stems = scan.points_on(on::stem);
  ASSERT_GT(stems.size(), 1000u);  // there is something to be distinguished
  const SphereSearchResult result = found_in(scan, settings.radius);
  ASSERT_THAT(result.spheres, SizeIs(3));
  for (const FoundSphere& sphere : result.spheres) {
    std::vector<int> shared;
    std::set_intersection(stems.begin(), stems.end(), sphere.points.begin(), sphere.points.end(),
                          std::back_inserter(shared));
    EXPECT_LT(static_cast<double>(shared.size()), 0.002 * static_cast<double>(sphere.points.size()));
  }
}

TEST(FindSpheres, ABallOnTheTableItTouches) {
  const double radius = 10.0;
  const Eigen::Matrix3Xd ball = cap({0.0, 0.0, radius}, radius, 2.0, 6000, 0.01);
  RandomStream random(3, "table");
  Eigen::Matrix3Xd points(3, ball.cols() + 20'000);
  points.leftCols(ball.cols()) = ball;
  for (Eigen::Index i = ball.cols(); i < points.cols(); ++i) {
    points.col(i) << random.uniform(-8.0, 8.0), random.uniform(-8.0, 8.0), 0.01 * random.normal();
  }
  const auto result = find_spheres(points, {{radius}}).value();
  ASSERT_THAT(result.spheres, SizeIs(1));
  EXPECT_LT((result.spheres[0].fitted.feature.centre - Eigen::Vector3d(0.0, 0.0, radius)).norm(), 0.001);
  const auto& own = result.spheres[0].points;
  const auto of_the_table = own.end() - std::lower_bound(own.begin(), own.end(), ball.cols());
  EXPECT_LT(static_cast<double>(of_the_table), 0.01 * static_cast<double>(own.size()));
  EXPECT_GT(own.size(), 5500u);
}

TEST(FindSpheres, AnotherRadiusIsSaidSo) {
  ScanSettings settings = bar(13.5, 0.02, 1.5, 0.6);
  const SimulatedScan scan = simulate_scan(settings);
  const SphereSearchResult result = found_in(scan, 12.7);
  EXPECT_THAT(result.spheres, IsEmpty());
  ASSERT_THAT(result.rejected, SizeIs(::testing::Ge(3u)));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(result.rejected[static_cast<std::size_t>(i)].reason, RejectionReason::WrongRadius);
    EXPECT_THAT(result.rejected[static_cast<std::size_t>(i)].why,
                ::testing::ContainsRegex("a sphere of radius 13\\.(49|5)"));
    EXPECT_NEAR(result.rejected[static_cast<std::size_t>(i)].sphere.radius, 13.5, 0.02);
  }
}

TEST(FindSpheres, TwoRadiiInOneScan) {
  Eigen::Matrix3Xd points(3, 4000);
  points << cap({0.0, 0.0, 0.0}, 12.7, 1.3, 2000, 0.01), cap({60.0, 0.0, 0.0}, 15.0, 1.3, 2000, 0.01);
  const auto result = find_spheres(points, {{15.0, 12.7, 12.7}}).value();
  ASSERT_THAT(result.spheres, SizeIs(2));
  EXPECT_EQ(near(result, {0.0, 0.0, 0.0})->radius_wanted, 12.7);
  EXPECT_EQ(near(result, {60.0, 0.0, 0.0})->radius_wanted, 15.0);
}

// ---- where there is no sphere -----------------------------------------------------------------------------------

Eigen::Matrix3Xd surface(int count, double noise, const std::function<Eigen::Vector3d(double, double)>& at) {
  RandomStream random(9, "surface");
  Eigen::Matrix3Xd points(3, count);
  for (int i = 0; i < count; ++i) {
    const double v = random.uniform();
    const double u = random.uniform();
    const Eigen::Vector3d p = at(u, v);
    points.col(i) = p + noise * normal_vector(random);
  }
  return points;
}

TEST(FindSpheres, OtherShapesAreNone) {
  const double r = 12.7;
  const auto plane = [](double u, double v) { return Eigen::Vector3d(300.0 * u, 300.0 * v, 0.0); };
  const auto cylinder = [&](double u, double v) {
    return Eigen::Vector3d(r * std::cos(6.283 * u), r * std::sin(6.283 * u), 200.0 * v);
  };
  const auto thin_cylinder = [&](double u, double v) {
    return Eigen::Vector3d(0.8 * r * std::cos(6.283 * u), 0.8 * r * std::sin(6.283 * u), 60.0 * v);
  };
  const auto cone = [&](double u, double v) {
    return Eigen::Vector3d(20.0 * v * std::cos(6.283 * u), 20.0 * v * std::sin(6.283 * u), 40.0 * v);
  };
  const auto saddle = [&](double u, double v) {
    const double x = 40.0 * u - 20.0, y = 40.0 * v - 20.0;
    return Eigen::Vector3d(x, y, (x * x - y * y) / (2.0 * r));
  };
  const auto ellipsoid = [&](double u, double v) {
    const double z = 2.0 * v - 1.0, a = std::sqrt(1.0 - z * z);
    return Eigen::Vector3d(1.1 * r * a * std::cos(6.283 * u), r * a * std::sin(6.283 * u), 0.9 * r * z);
  };
  const auto box = [&](double u, double v) {
    const double s = 20.0;
    const int face = static_cast<int>(6.0 * u);
    const double a = s * (6.0 * u - face), b = s * v, c = face % 2 == 0 ? 0.0 : s;
    return face < 2 ? Eigen::Vector3d(a, b, c) : face < 4 ? Eigen::Vector3d(c, a, b) : Eigen::Vector3d(b, c, a);
  };
  const auto lump = [&](double u, double v) {
    return Eigen::Vector3d(30.0 * u, 30.0 * v, 30.0 * std::fmod(97.0 * (u + v), 1.0));
  };
  for (const int count : {300, 3000, 30'000}) {
    for (const double noise : {0.0, 0.02, 0.2}) {
      SCOPED_TRACE(std::to_string(count) + " points, noise " + std::to_string(noise));
      EXPECT_THAT(find_spheres(surface(count, noise, plane), {{r}})->spheres, IsEmpty()) << "plane";
      EXPECT_THAT(find_spheres(surface(count, noise, cylinder), {{r}})->spheres, IsEmpty()) << "cylinder";
      EXPECT_THAT(find_spheres(surface(count, noise, thin_cylinder), {{r}})->spheres, IsEmpty()) << "thin cylinder";
      EXPECT_THAT(find_spheres(surface(count, noise, cone), {{r}})->spheres, IsEmpty()) << "cone";
      EXPECT_THAT(find_spheres(surface(count, noise, saddle), {{r}})->spheres, IsEmpty()) << "saddle";
      EXPECT_THAT(find_spheres(surface(count, noise, ellipsoid), {{r}})->spheres, IsEmpty()) << "ellipsoid";
      EXPECT_THAT(find_spheres(surface(count, noise, box), {{r}})->spheres, IsEmpty()) << "box";
      EXPECT_THAT(find_spheres(surface(count, noise, lump), {{r}})->spheres, IsEmpty()) << "lump";
    }
  }
}

TEST(FindSpheres, FewPointsOrNoneOrAllTheSame) {
  const SphereSearch search{{10.0}};
  EXPECT_THAT(find_spheres(Eigen::Matrix3Xd(3, 0), search)->spheres, IsEmpty());
  EXPECT_THAT(find_spheres(Eigen::Matrix3Xd::Zero(3, 1), search)->spheres, IsEmpty());
  EXPECT_THAT(find_spheres(Eigen::Matrix3Xd::Constant(3, 5000, 17.0), search)->spheres, IsEmpty());
  for (const int count : {2, 3, 5, 8, 9}) {
    EXPECT_THAT(find_spheres(cap({0.0, 0.0, 0.0}, 10.0, 1.5, count), search)->spheres, IsEmpty()) << count;
  }
}

TEST(FindSpheres, AFewDozenPointsAreEnough) {
  const auto result = find_spheres(cap({1.0, 2.0, 3.0}, 10.0, 1.5, 60, 0.01), {{10.0}}).value();
  ASSERT_THAT(result.spheres, SizeIs(1));
  EXPECT_LT((result.spheres[0].fitted.feature.centre - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 0.01);
}

TEST(FindSpheres, BadPointsAndWrongCalls) {
  auto points = cap({0.0, 0.0, 0.0}, 10.0, 1.5, 1000);
  EXPECT_EQ(find_spheres(points, {{-1.0}}).error().code, ErrorCode::Usage);
  EXPECT_EQ(find_spheres(points, {{0.0}}).error().code, ErrorCode::Usage);
  EXPECT_EQ(find_spheres(points, {{std::nan("")}}).error().code, ErrorCode::Usage);
  EXPECT_EQ(find_spheres(points, {{10.0}, 0.0}).error().code, ErrorCode::Usage);
  points(1, 7) = 1e15;  // in range of a double, but not of anything that holds a sphere of 10 mm
  const auto far = find_spheres(points, {{10.0}});
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().code, ErrorCode::BadInput);
  EXPECT_THAT(far.error().message, HasSubstr("is the unit right"));
  points(1, 7) = std::nan("");
  const auto nan = find_spheres(points, {{10.0}});
  ASSERT_FALSE(nan);
  EXPECT_THAT(nan.error().message, HasSubstr("point 7 is not a number"));
}

// ---- what is said of a sphere -------------------------------------------------------------------------------------

TEST(FindSpheres, SaysCoverageNoiseAndTheRadiusItSees) {
  for (const double angle : {0.6, 1.0, 1.5, 2.5}) {
    const auto result = find_spheres(cap({5.0, 0.0, -3.0}, 10.02, angle, 20'000, 0.03), {{10.0}, 0.02, false}).value();
    ASSERT_THAT(result.spheres, SizeIs(1)) << angle;
    const FoundSphere& sphere = result.spheres[0];
    EXPECT_NEAR(sphere.coverage, (1.0 - std::cos(angle)) / 2.0, 0.03);
    EXPECT_NEAR(sphere.fitted.rms, 0.03, 0.001);
    EXPECT_NEAR(sphere.seen_radius, 10.02, 5.0 * sphere.u_seen_radius);
    EXPECT_LT(sphere.u_seen_radius, 0.01);
    EXPECT_EQ(sphere.fitted.feature.radius, sphere.seen_radius);
    EXPECT_EQ(sphere.fitted.residuals.size(), static_cast<Eigen::Index>(sphere.points.size()));
  }
}

TEST(FindSpheres, AKnownRadiusIsHeld) {
  const auto result = find_spheres(cap({5.0, 0.0, -3.0}, 10.02, 1.0, 20'000, 0.03), {{10.0}}).value();
  ASSERT_THAT(result.spheres, SizeIs(1));
  EXPECT_EQ(result.spheres[0].fitted.feature.radius, 10.0);
  EXPECT_NEAR(result.spheres[0].seen_radius, 10.02, 5.0 * result.spheres[0].u_seen_radius);
}

// ---- the same again -----------------------------------------------------------------------------------------------

TEST(FindSpheres, TwiceTheSameBytes) {
  const SimulatedScan scan = simulate_scan(bar(12.7, 0.02, 2.0, 0.8));
  const SphereSearchResult a = found_in(scan, 12.7);
  const SphereSearchResult b = found_in(scan, 12.7);
  ASSERT_EQ(a.spheres.size(), b.spheres.size());
  for (std::size_t i = 0; i < a.spheres.size(); ++i) {
    EXPECT_EQ(a.spheres[i].points, b.spheres[i].points);
    EXPECT_EQ(a.spheres[i].fitted.feature.centre, b.spheres[i].fitted.feature.centre);
    EXPECT_TRUE(std::is_sorted(a.spheres[i].points.begin(), a.spheres[i].points.end()));
  }
}

TEST(FindSpheres, TheOrderOfThePointsDoesNotMatter) {
  const SimulatedScan scan = simulate_scan(bar(12.7, 0.02, 2.0, 0.8));
  std::vector<int> order(static_cast<std::size_t>(scan.points.cols()));
  std::iota(order.begin(), order.end(), 0);
  RandomStream random(2, "shuffle");
  for (std::size_t i = order.size() - 1; i > 0; --i) {
    std::swap(order[i], order[static_cast<std::size_t>(random.uniform() * static_cast<double>(i + 1))]);
  }
  Eigen::Matrix3Xd shuffled(3, scan.points.cols());
  for (std::size_t i = 0; i < order.size(); ++i) {
    shuffled.col(static_cast<Eigen::Index>(i)) = scan.points.col(order[i]);
  }
  const SphereSearchResult a = found_in(scan, 12.7);
  const SphereSearchResult b = find_spheres(shuffled, {{12.7}}).value();
  ASSERT_EQ(a.spheres.size(), b.spheres.size());
  for (const FoundSphere& sphere : a.spheres) {
    const FoundSphere* other = near(b, sphere.fitted.feature.centre);
    ASSERT_NE(other, nullptr);
    std::set<int> back;
    for (const int i : other->points) back.insert(order[static_cast<std::size_t>(i)]);
    EXPECT_EQ(back, std::set<int>(sphere.points.begin(), sphere.points.end()));
  }
}

}  // namespace
}  // namespace artcal::testing
