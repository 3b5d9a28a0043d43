#include "core/rigid.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace artcal {
namespace {

Rigid random_motion(RandomStream& random) { return {random.rotation(), 1000.0 * random.direction()}; }

TEST(Rigid, ActsAsRotationThenTranslation) {
  Rigid a_from_b;
  a_from_b.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // a quarter turn about z
  a_from_b.translation = {10.0, 20.0, 30.0};
  EXPECT_EQ(a_from_b * Eigen::Vector3d(1.0, 2.0, 3.0), Eigen::Vector3d(8.0, 21.0, 33.0));
}

TEST(Rigid, CompositionIsOneAfterTheOther) {
  RandomStream random(1, "rigid");
  for (int i = 0; i < 100; ++i) {
    const Rigid a_from_b = random_motion(random);
    const Rigid b_from_c = random_motion(random);
    const Eigen::Vector3d point_in_c = 500.0 * random.direction();
    EXPECT_LT(((a_from_b * b_from_c) * point_in_c - a_from_b * (b_from_c * point_in_c)).norm(), 1e-11);
  }
}

TEST(Rigid, InverseUndoes) {
  RandomStream random(2, "rigid");
  for (int i = 0; i < 100; ++i) {
    const Rigid a_from_b = random_motion(random);
    const Eigen::Vector3d point_in_b = 500.0 * random.direction();
    EXPECT_LT((a_from_b.inverse() * (a_from_b * point_in_b) - point_in_b).norm(), 1e-11);
    EXPECT_LT((a_from_b * (a_from_b.inverse() * point_in_b) - point_in_b).norm(), 1e-11);
  }
}

}  // namespace
}  // namespace artcal
