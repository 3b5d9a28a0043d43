// Every variant that this machine has, against FeatureResidual and its rows of one reading after the other.
#include "identification/least_squares/kernels/ball_rows.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "identification/least_squares/residual.h"

namespace artcal {
namespace {

constexpr int columns = 21;
constexpr int stride = 3 + columns + 1;  // [centre | arm | residual]

TEST(BallRows, HasTheBytesOfEachReadingWithEveryInstructionSet) {
  RandomStream random(4, "ball");
  std::vector<double> tips(24), derivative(24 * columns), scale(columns);
  for (auto* numbers : {&tips, &derivative, &scale}) {
    for (double& number : *numbers) {
      number = random.uniform(-700.0, 700.0);
    }
  }
  FeatureConstraint ball;
  ball.kind = OnBall{12.7};
  const Eigen::Vector3d centre(tips[5], tips[13], tips[21]);  // the sixth reading is at the centre itself
  const FeatureResidual residual(ball, {}, centre.data(), nullptr);
  BallReadings readings{tips.data(), derivative.data(), columns, {centre.x(), centre.y(), centre.z()}, {}, {}};
  for (int i = 0; i < 8; ++i) {
    readings.lengths[i] = 12.7 + 3.0;
    readings.weights[i] = random.uniform(50.0, 300.0);
  }
  for (const int count : {1, 5, 8}) {
    std::vector<double> expected(8 * stride, -1.0);
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d tip(tips[i], tips[8 + i], tips[16 + i]);
      const Residual r = residual.at(0, tip, 3.0, true);
      const double weight = readings.weights[i];
      double* row = expected.data() + i * stride;
      const Eigen::RowVector3d by_tip = weight * r.by_tip.row(0);
      for (int k = 0; k < 3; ++k) {
        row[k] = weight * r.by_unknowns(0, k);
      }
      for (int c = 0; c < columns; ++c) {
        const double* d = derivative.data() + 24 * c + i;
        row[3 + c] = scale[c] * (by_tip[0] * d[0] + by_tip[1] * d[8] + by_tip[2] * d[16]);
      }
      row[3 + columns] = weight * r.value[0];
    }
    for (const BallRowsVariant& variant : ball_rows_variants()) {
      std::vector<double> rows(8 * stride, -1.0);
      variant.put(readings, scale.data(), count, stride, rows.data() + 3 + columns, rows.data(), rows.data() + 3);
      EXPECT_EQ(rows, expected) << variant.instructions << ", " << count;
    }
  }
}

}  // namespace
}  // namespace artcal
