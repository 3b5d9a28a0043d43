// The fits against published reference pairs (tests/reference/nist-geometric-elements/NOTE.md).
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

namespace fs = std::filesystem;

constexpr double length_bound = 1e-9;  // mm
constexpr double angle_bound = 1e-10;  // rad
constexpr double degree_bound = 1e-9;  // °

struct Score {
  double length = 0.0, angle = 0.0, degrees = 0.0;
  int pairs = 0;

  void worsen(const Score& other) {
    length = std::max(length, other.length);
    angle = std::max(angle, other.angle);
    degrees = std::max(degrees, other.degrees);
    pairs += 1;
  }
};

std::vector<double> numbers_in(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istream_iterator<double>(stream), {}};
}

struct Pair {
  Eigen::Matrix3Xd points;
  std::vector<double> answer;
  [[nodiscard]] Eigen::Vector3d vector(std::size_t at) const { return Eigen::Vector3d::Map(answer.data() + at); }
};

Pair read_pair(fs::path data) {
  const auto numbers = numbers_in(data);
  const auto count = static_cast<Eigen::Index>(numbers.at(0));
  EXPECT_EQ(static_cast<Eigen::Index>(numbers.size()), 1 + 3 * count) << data;
  return {Eigen::Map<const Eigen::Matrix3Xd>(numbers.data() + 1, 3, count), numbers_in(data.replace_extension(".fit"))};
}

template <typename F>
F fitted(const Pair& pair) {
  const auto result = fit<F>(pair.points);
  EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().text());
  EXPECT_EQ(result->status, FitStatus::Converged);
  return result->feature;
}

Score score(const Pair& pair, const Sphere& f) {
  return {std::max((f.centre - pair.vector(0)).norm(), std::abs(2.0 * f.radius - pair.answer[3]))};
}
Score score(const Pair& pair, const Plane& f) {
  return {std::abs(f.normal.dot(pair.vector(0) - f.point)), angle_between(f.normal, pair.vector(3))};
}
Score score(const Pair& pair, const Circle& f) {
  return {std::max((f.centre - pair.vector(0)).norm(), std::abs(2.0 * f.radius - pair.answer[6])),
          angle_between(f.normal, pair.vector(3))};
}
Score score(const Pair& pair, const Cylinder& f) {
  return {std::max(off_axis(pair.vector(0), f.point, f.direction), std::abs(2.0 * f.radius - pair.answer[6])),
          angle_between(f.direction, pair.vector(3))};
}
Score score(const Pair& pair, const Cone& f) {
  // The reference's distance is the one from its own axis point, square to the surface.
  const double across = f.radius + std::tan(f.half_angle) * f.direction.dot(pair.vector(0) - f.point);
  return {std::max(off_axis(pair.vector(0), f.point, f.direction),
                   std::abs(std::cos(f.half_angle) * across - pair.answer[6])),
          angle_between(f.direction, pair.vector(3)), std::abs(2.0 * f.half_angle * 180.0 / pi - pair.answer[7])};
}

template <typename F>
void score_all(const char* folder) {
  const fs::path root = fs::path(ARTCAL_SOURCE_DIR) / "tests/reference/nist-geometric-elements" / folder;
  Score worst;
  for (const auto& entry : fs::directory_iterator(root)) {
    if (entry.path().extension() != ".ds") {
      continue;
    }
    SCOPED_TRACE(entry.path().string());
    const Pair pair = read_pair(entry.path());
    const Score one = score(pair, fitted<F>(pair));
    EXPECT_LT(one.length, length_bound);
    EXPECT_LT(one.angle, angle_bound);
    EXPECT_LT(one.degrees, degree_bound);
    worst.worsen(one);
  }
  EXPECT_GT(worst.pairs, 0);
  fmt::print("{:<9} {:>2} pairs: worst {:.1e} mm, {:.1e} rad, {:.1e} deg\n", folder, worst.pairs, worst.length,
             worst.angle, worst.degrees);
}

TEST(ReferencePairs, Plane) { score_all<Plane>("Plane"); }
TEST(ReferencePairs, Sphere) { score_all<Sphere>("Sphere"); }
TEST(ReferencePairs, Circle) { score_all<Circle>("Circle3d"); }
TEST(ReferencePairs, Cylinder) { score_all<Cylinder>("Cylinder"); }
TEST(ReferencePairs, Cone) { score_all<Cone>("Cone"); }

}  // namespace
}  // namespace artcal::test
