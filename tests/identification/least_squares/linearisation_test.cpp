// The compression must lose nothing: cost, gradient and normal matrix are those of the rows behind it.
#include "identification/least_squares/linearisation.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "core/random.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/row_stack.h"
#include "identification/least_squares/rows.h"
#include "identification/least_squares/triangular_factor.h"
#include "identification/problem/weights.h"
#include "tests/support/recordings.h"

namespace artcal {
namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, RandomStream& random) {
  Eigen::MatrixXd m(rows, columns);
  for (double& v : m.reshaped()) v = random.normal();
  return m;
}

TEST(TriangularFactor, HasTheSingularValuesOfAllRows) {
  RandomStream random(1, "factor");
  for (const Eigen::Index rows : {3, 7, 192, 193, 1000}) {
    const Eigen::MatrixXd all = random_matrix(rows, 7, random) * Eigen::VectorXd::LinSpaced(7, 1.0, 1e-9).asDiagonal();
    TriangularFactor factor(7);
    for (Eigen::Index first = 0; first < rows; first += 50) {
      factor.add(all.middleRows(first, std::min<Eigen::Index>(50, rows - first)));
    }
    const Eigen::MatrixXd triangle = factor.triangle();
    EXPECT_TRUE(triangle.isUpperTriangular());
    const Eigen::VectorXd expected = all.jacobiSvd().singularValues();
    const Eigen::VectorXd found = triangle.jacobiSvd().singularValues().head(expected.size());
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-14 * expected[0]) << rows;
  }
}

// Rows of several features: each has columns of its own, which are zero in the others' rows.
Eigen::MatrixXd rows_of_features(Eigen::Index features, Eigen::Index of_each, RandomStream& random) {
  Eigen::MatrixXd rows = random_matrix(features * of_each, 2 * features + 3, random);
  for (Eigen::Index f = 0; f < features; ++f) {
    for (Eigen::Index other = 0; other < features; ++other) {
      if (other != f) rows.block(f * of_each, 2 * other, of_each, 2).setZero();
    }
  }
  return rows;
}

// Stored row by row or column by column, the rows are the same.
TEST(TriangularFactor, OfRowsWithManyZeros) {
  RandomStream random(3, "factor");
  for (const Eigen::Index of_each : {1, 2, 7, 24, 70}) {
    const Eigen::MatrixXd all = rows_of_features(4, of_each, random);
    const RowMatrix by_rows = all;
    TriangularFactor factor(11);
    TriangularFactor same(11);
    factor.add(all);
    same.add(by_rows);
    const Eigen::MatrixXd triangle = factor.triangle();
    EXPECT_EQ(triangle, same.triangle()) << of_each;
    const Eigen::MatrixXd gram = all.transpose() * all;
    EXPECT_LT((triangle.transpose() * triangle - gram).cwiseAbs().maxCoeff(), 1e-13 * gram.norm()) << of_each;
    TriangularFactor again(11);
    again.add(triangle);
    const Eigen::MatrixXd folded = again.triangle();
    EXPECT_LT((folded.cwiseAbs() - triangle.cwiseAbs()).cwiseAbs().maxCoeff(), 1e-13 * triangle.norm()) << of_each;
  }
}

TEST(RowStack, TakesRowsHoweverTheyAreStored) {
  RandomStream random(4, "factor");
  const Eigen::MatrixXd all = random_matrix(30, 9, random);
  for (const Folding folding : {Folding::Reflections, Folding::NormalEquations}) {
    for (const Eigen::Index count : {5, 9, 30}) {
      RowStack by_columns(9, folding);
      RowStack by_rows(9, folding);
      by_columns.add(all.topRows(count));
      by_rows.add(RowMatrix(all.topRows(count)));
      EXPECT_EQ(by_columns.rows(), by_rows.rows()) << count;
    }
  }
}

TEST(TriangularFactor, EliminationLeavesWhatIsOrthogonalToTheNuisance) {
  RandomStream random(2, "factor");
  const Eigen::MatrixXd wanted = random_matrix(40, 4, random);
  Eigen::MatrixXd nuisance = random_matrix(40, 3, random);
  nuisance.col(2) = nuisance.col(0) - 2.0 * nuisance.col(1);  // rank 2
  TriangularFactor factor(7);
  Eigen::MatrixXd both(40, 7);
  both << nuisance, wanted;
  factor.add(both);
  const Eigen::MatrixXd rest = eliminate_leading(factor.triangle(), 3);
  const Eigen::MatrixXd basis =
      nuisance.leftCols<2>().householderQr().householderQ() * Eigen::MatrixXd::Identity(40, 2);
  const Eigen::MatrixXd projected = wanted - basis * (basis.transpose() * wanted);
  EXPECT_LT((rest.transpose() * rest - projected.transpose() * projected).norm(), 1e-12);
}

class Compression : public ::testing::TestWithParam<Loss> {};

TEST_P(Compression, KeepsCostAndGradient) {
  const test::Bound bound = test::read_bound(test::example("two-socket-bar/recording.toml"));
  const Arm& arm = bound.recording.arm;
  const System system = make_system(bound.recording, bound.constraints, arm, parameters_of(arm));
  const auto unknowns = estimate_nuisance_parameters(system, arm, bound.recording);
  const Weights weights = uniform_weights(bound.constraints, 0.5);
  const auto kinematics_by_probe = forward_kinematics_of(system, arm);
  const auto blocks = blocks_of(bound.constraints);
  const Linearisation linearisation = linearise(system, weights, GetParam(), arm, *unknowns);
  ASSERT_EQ(linearisation.blocks.size(), blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].group < 0) {
      continue;
    }
    const GroupState& group = unknowns->groups[blocks[b].group];
    const Eigen::MatrixXd& triangle = linearisation.blocks[b].rows;
    const Eigen::VectorXd z = triangle.rightCols<1>();
    const auto cost_at = [&](const Eigen::VectorXd& values) {
      return block_cost(system, weights, GetParam(), blocks[b], kinematics_by_probe,
                        {group.reference, values.data(), unknowns->shared.data()});
    };
    EXPECT_NEAR(z.squaredNorm() / cost_at(group.values), 1.0, 1e-12);
    // The gradient by the unknowns against differences of the cost itself.
    const Eigen::VectorXd gradient = 2.0 * triangle.leftCols(group.values.size()).transpose() * z;
    for (Eigen::Index i = 0; i < gradient.size(); ++i) {
      const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(gradient.size(), i);
      const double slope = (cost_at(group.values + step) - cost_at(group.values - step)) / 2e-5;
      EXPECT_NEAR(slope, gradient[i], 1e-4 * (1.0 + std::abs(slope)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Losses, Compression, ::testing::Values(Loss::None, Loss::Huber, Loss::Cauchy));

TEST(Loss, SlopesAreTheDerivativesAndBothAreConcave) {
  for (const Loss loss : {Loss::None, Loss::Huber, Loss::Cauchy}) {
    for (const double s : {0.01, 0.5, 1.7, 1.9, 5.0, 100.0, 1e6}) {
      const double h = 1e-6 * s;
      const LossValue rho = loss_at(loss, s);
      EXPECT_NEAR((loss_at(loss, s + h).value - loss_at(loss, s - h).value) / (2 * h), rho.slope, 1e-8);
      EXPECT_GE(rho.value, s * rho.slope);
    }
    EXPECT_EQ(loss_at(loss, 0.0).value, 0.0);
  }
}

}  // namespace
}  // namespace artcal
