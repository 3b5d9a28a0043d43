#include "core/random.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/LU>

namespace artcal {
namespace {

constexpr int many = 200'000;

// Results name their seed; they can be made again only as long as these numbers stand.
TEST(RandomStream, GivesThePinnedNumbers) {
  RandomStream random(2013, "readings", 7);
  EXPECT_EQ(random.bits(), 0xba76570541ab3f26ULL);
  EXPECT_EQ(random.bits(), 0x35fc75e9e1493801ULL);
  EXPECT_EQ(random.bits(), 0x5aa982598896dc8dULL);
  EXPECT_EQ(random.bits(), 0x9e5126b7da2d19aaULL);
  EXPECT_EQ(random.uniform(), 0x1.3757b1986f264p-2);
  EXPECT_EQ(random.uniform(), 0x1.f2cc2a554395ep-2);
  EXPECT_DOUBLE_EQ(random.normal(), -1.14671976587574);
  EXPECT_DOUBLE_EQ(random.normal(), -1.5744182291798623);
  EXPECT_LT(
      (random.direction() - Eigen::Vector3d(0.057738163238272334, 0.78247300834547984, -0.62000185138162711)).norm(),
      1e-15);
  EXPECT_LT((random.rotation().col(0) - Eigen::Vector3d(-0.37920586405875323, 0.32398563708714562, 0.86673884164994619))
                .norm(),
            1e-15);
}

TEST(RandomStream, SameSeedNameAndIndexGiveTheSameNumbers) {
  RandomStream first(1, "a", 2);
  RandomStream second(1, "a", 2);
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(first.bits(), second.bits());
  }
}

TEST(RandomStream, EverySeedNameAndIndexHasItsOwnNumbers) {
  std::set<std::uint64_t> first_numbers;
  int streams = 0;
  for (const std::uint64_t seed : {0u, 1u, 2u}) {
    for (const char* name : {"", "a", "b", "ab", "ba"}) {
      for (const std::uint64_t index : {0u, 1u, 2u, 1000u}) {
        first_numbers.insert(RandomStream(seed, name, index).bits());
        ++streams;
      }
    }
  }
  EXPECT_EQ(static_cast<int>(first_numbers.size()), streams);
}

TEST(RandomStream, UniformHasTheMomentsOfItsInterval) {
  RandomStream random(1, "uniform");
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < many; ++i) {
    const double u = random.uniform(-2.0, 4.0);
    ASSERT_GE(u, -2.0);
    ASSERT_LT(u, 4.0);
    sum += u;
    squares += (u - 1.0) * (u - 1.0);
  }
  // Five standard errors of the mean and of the variance.
  EXPECT_NEAR(sum / many, 1.0, 5.0 * std::sqrt(3.0 / many));
  EXPECT_NEAR(squares / many, 3.0, 5.0 * std::sqrt((81.0 / 5.0 - 9.0) / many));
}

TEST(RandomStream, NormalHasTheMomentsAndTailOfTheNormal) {
  RandomStream random(1, "normal");
  double m1 = 0.0;
  double m2 = 0.0;
  double m3 = 0.0;
  double m4 = 0.0;
  int beyond_two = 0;
  for (int i = 0; i < many; ++i) {
    const double x = random.normal();
    m1 += x / many;
    m2 += x * x / many;
    m3 += x * x * x / many;
    m4 += x * x * x * x / many;
    beyond_two += std::abs(x) > 2.0 ? 1 : 0;
  }
  EXPECT_NEAR(m1, 0.0, 5.0 * std::sqrt(1.0 / many));
  EXPECT_NEAR(m2, 1.0, 5.0 * std::sqrt(2.0 / many));
  EXPECT_NEAR(m3, 0.0, 5.0 * std::sqrt(15.0 / many));
  EXPECT_NEAR(m4, 3.0, 5.0 * std::sqrt(96.0 / many));
  EXPECT_NEAR(beyond_two / double{many}, 0.0455003, 5.0 * std::sqrt(0.0455 * 0.9545 / many));
}

TEST(RandomStream, SuccessiveNormalsAreIndependent) {
  RandomStream random(1, "pairs");
  double product = 0.0;
  for (int i = 0; i < many; ++i) {
    const double x = random.normal();
    product += x * random.normal() / many;
  }
  EXPECT_NEAR(product, 0.0, 5.0 / std::sqrt(many));
}

TEST(RandomStream, DirectionsFillTheSphereEvenly) {
  RandomStream random(1, "directions");
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (int i = 0; i < many; ++i) {
    const Eigen::Vector3d v = random.direction();
    ASSERT_NEAR(v.norm(), 1.0, 1e-15);
    mean += v / many;
    second += v * v.transpose() / many;
  }
  EXPECT_LT(mean.norm(), 6.0 / std::sqrt(3.0 * many));
  EXPECT_LT((second - Eigen::Matrix3d::Identity() / 3.0).cwiseAbs().maxCoeff(), 5.0 * std::sqrt(0.1 / many));
}

// Uniform over SO(3): each column is a uniform direction, and the trace has mean 0 (density of the
// turning angle (1 - cos)/pi), which a rotation drawn from uniform angles does not have.
TEST(RandomStream, RotationsAreRotationsAndEven) {
  RandomStream random(1, "rotations");
  Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
  for (int i = 0; i < many; ++i) {
    const Eigen::Matrix3d r = random.rotation();
    ASSERT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    ASSERT_GT(r.determinant(), 0.0);
    mean += r / many;
  }
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 5.0 / std::sqrt(3.0 * many));
}

}  // namespace
}  // namespace artcal
