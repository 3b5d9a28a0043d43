#include "identification/least_squares/kernels/normal_triangle.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace artcal {
namespace {

Eigen::MatrixXd rows_of(Eigen::Index rows, Eigen::Index columns) {
  RandomStream random(7, "rows");
  Eigen::MatrixXd all(rows, columns);
  for (double& number : all.reshaped()) {
    number = random.normal();
  }
  return all;
}

TEST(NormalTriangle, HasTheNormalMatrixOfAllRowsHoweverTheyCome) {
  for (const int columns : {1, 8, 13, 39}) {
    const Eigen::MatrixXd rows = rows_of(250, columns);
    NormalTriangle triangle(columns);
    triangle.add(rows.topRows(7));
    triangle.add(rows.middleRows(7, 193));
    triangle.add(rows.bottomRows(50));
    const Eigen::MatrixXd r = triangle.triangle();
    EXPECT_TRUE(r.isUpperTriangular(0.0));
    EXPECT_LT((r.transpose() * r - rows.transpose() * rows).norm(), 1e-12 * rows.squaredNorm()) << columns;
  }
}

TEST(NormalTriangle, GivesARowOfZerosToAColumnThatFollowsFromOthers) {
  Eigen::MatrixXd rows = rows_of(60, 6);
  rows.col(3) = 2.0 * rows.col(0) - rows.col(2);
  rows.col(4).setZero();
  NormalTriangle triangle(6);
  triangle.add(rows);
  const Eigen::MatrixXd r = triangle.triangle();
  EXPECT_EQ(r.row(3).norm(), 0.0);
  EXPECT_EQ(r.row(4).norm(), 0.0);
  EXPECT_LT((r.transpose() * r - rows.transpose() * rows).norm(), 1e-12 * rows.squaredNorm());
}

}  // namespace
}  // namespace artcal
