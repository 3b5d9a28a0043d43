// Against a dense QR and a dense inverse of the same rows, which know nothing of blocks.
#include "identification/least_squares/elimination.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include "core/random.h"
#include "identification/monte_carlo/arrow_factor.h"
#include "identification/uncertainty/fit_spread.h"

namespace artcal {
namespace {

constexpr int arm_size = 5;

/// Random rows of artefacts: each reads `features` features in `placements` placements.
struct Artefacts {
  std::vector<std::pair<int, int>> sizes;  // placements, features
  int readings = 4;
  std::vector<int> pattern{3, 1, 4};  // parameters of a feature, in turns
};

Linearisation random_linearisation(const Artefacts& artefacts, bool certified = true) {
  RandomStream random(3, "elimination");
  const auto fill = [&](Eigen::Index rows, Eigen::Index columns) {
    Eigen::MatrixXd m(rows, columns);
    for (double& v : m.reshaped()) v = random.normal();
    return m;
  };
  Linearisation all;
  all.blocks.push_back({-1, 0, {}, fill(2, arm_size + 1)});
  int group = 0;
  int parameter = 0;
  std::vector<BlockRows> certificates;
  for (const auto& [placements, features] : artefacts.sizes) {
    std::vector<FeatureParameters> parameters;
    for (int f = 0; f < features; ++f) {
      const int size = artefacts.pattern[f % artefacts.pattern.size()];
      parameters.push_back({parameter, size});
      parameter += size;
      if (certified) certificates.push_back({-1, 0, parameters.back(), fill(size, size + arm_size + 1)});
    }
    for (int p = 0; p < placements; ++p, ++group) {
      all.layout.groups.push_back(all.layout.common);
      all.layout.common += 6;
      all.blocks.push_back({group, 6, {}, fill(artefacts.readings, 6 + arm_size + 1)});
      for (const FeatureParameters& of_feature : parameters) {
        all.blocks.push_back({group, 6, of_feature, fill(artefacts.readings, 6 + of_feature.size + arm_size + 1)});
      }
    }
  }
  for (BlockRows& certificate : certificates) {
    certificate.rows.middleCols(certificate.parameters.size, arm_size).setZero();
    all.blocks.push_back(std::move(certificate));
  }
  all.layout.arm = all.layout.common + parameter;
  all.layout.size = all.layout.arm + arm_size;
  return all;
}

// All rows with a column for every unknown, and the residual last.
Eigen::MatrixXd dense(const Linearisation& linearisation) {
  const StateLayout& layout = linearisation.layout;
  Eigen::MatrixXd all(0, layout.size + 1);
  for (const BlockRows& block : linearisation.blocks) {
    const Eigen::Index first = all.rows();
    all.conservativeResize(first + block.rows.rows(), Eigen::NoChange);
    auto rows = all.bottomRows(block.rows.rows());
    rows.setZero();
    if (block.unknowns > 0) {
      rows.middleCols(layout.groups[block.group], block.unknowns) = block.rows.leftCols(block.unknowns);
    }
    rows.middleCols(layout.common + block.parameters.first, block.parameters.size) =
        block.rows.middleCols(block.unknowns, block.parameters.size);
    rows.rightCols(arm_size + 1) = block.rows.rightCols(arm_size + 1);
  }
  return all;
}

const std::vector<Artefacts> kinds{
    {{{3, 7}}},                  // features are the leaves
    {{{9, 2}}},                  // placements are
    {{{3, 7}, {9, 2}, {1, 1}}},  // several artefacts beside one another
    {{{2, 0}, {4, 5}}, 60},      // one without parameters; more readings than columns
};

TEST(Elimination, TheArmsTriangleIsThatOfTheRowsWithTheNuisanceProjectedOut) {
  for (const Artefacts& artefacts : kinds) {
    const Linearisation linearisation = random_linearisation(artefacts);
    const Eigen::MatrixXd all = dense(linearisation);
    const Eigen::Index nuisance = linearisation.layout.arm;
    const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(all.leftCols(nuisance)).householderQ() *
                              Eigen::MatrixXd::Identity(all.rows(), nuisance);
    const Eigen::MatrixXd wanted = all.rightCols(arm_size + 1);
    const Eigen::MatrixXd projected = wanted - q * (q.transpose() * wanted);
    // With the residual as one more column.
    const Eigen::MatrixXd found = eliminate_nuisance(linearisation, arm_size + 1);
    EXPECT_LT((found.transpose() * found - projected.transpose() * projected).norm(), 1e-11 * projected.squaredNorm());
  }
}

// Of rows that were folded already, and that see some unknowns only.
TEST(Elimination, RowsThatAreATriangleGiveWhatTheRowsBehindThemGive) {
  for (const Artefacts& artefacts : kinds) {
    Linearisation linearisation = random_linearisation(artefacts);
    const Eigen::MatrixXd expected = eliminate_nuisance(linearisation, arm_size + 1);
    for (BlockRows& block : linearisation.blocks) {
      if (block.rows.rows() > block.rows.cols()) {
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(block.rows);
        block.rows = qr.matrixQR().topRows(block.rows.cols()).triangularView<Eigen::Upper>();
      }
    }
    for (const Folding folding : {Folding::Reflections, Folding::NormalEquations}) {
      const Eigen::MatrixXd found = eliminate_nuisance(linearisation, arm_size + 1, nullptr, folding);
      EXPECT_LT((found.transpose() * found - expected.transpose() * expected).norm(), 1e-11 * expected.squaredNorm());
      EXPECT_TRUE(found.isUpperTriangular(0.0));
    }
  }
}

TEST(Elimination, NuisanceUnknownsMayBeRankDeficient) {
  Linearisation linearisation = random_linearisation({{{3, 7}}}, false);
  for (BlockRows& block : linearisation.blocks) {
    if (block.parameters.first == 0 && block.parameters.size > 0) {
      block.rows.col(block.unknowns) = block.rows.col(block.unknowns + 1);  // two that are distinguished by nothing
    }
  }
  const Eigen::MatrixXd all = dense(linearisation);
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> nuisance(all.leftCols(linearisation.layout.arm));
  const Eigen::MatrixXd wanted = all.middleCols(linearisation.layout.arm, arm_size);
  const Eigen::MatrixXd projected = wanted - all.leftCols(linearisation.layout.arm) * nuisance.solve(wanted);
  const Eigen::MatrixXd found = arm_triangle(linearisation, arm_size);
  EXPECT_LT((found.transpose() * found - projected.transpose() * projected).norm(), 1e-11 * projected.squaredNorm());
  EXPECT_FALSE(ArrowFactor::of(linearisation).has_value());
}

TEST(ArrowFactor, SolvesAsTheDenseNormalMatrixDoes) {
  for (const Artefacts& artefacts : kinds) {
    const Linearisation linearisation = random_linearisation(artefacts);
    const Eigen::MatrixXd all = dense(linearisation);
    const Eigen::MatrixXd j = all.leftCols(linearisation.layout.size);
    const Eigen::MatrixXd inverse = (j.transpose() * j).inverse();
    const Eigen::VectorXd gradient_there = j.transpose() * all.rightCols<1>();
    const auto factor = ArrowFactor::of(linearisation);
    ASSERT_TRUE(factor) << factor.error().text();
    const ArrowFactor::Step step = factor->solve(gradient_there);
    EXPECT_LT((step.numbers - inverse * gradient_there).norm(), 1e-9 * step.numbers.norm());
    EXPECT_NEAR(step.length, (j * step.numbers).norm(), 1e-9 * step.length);
    const Eigen::VectorXd variances =
        inverse.diagonal().segment(linearisation.layout.common, linearisation.layout.arm - linearisation.layout.common);
    EXPECT_LT((factor->parameter_variances() - variances).norm(), 1e-9 * variances.norm());
    Eigen::Index first = 0;
    for (const BlockRows& block : linearisation.blocks) {
      const Eigen::MatrixXd rows = j.middleRows(first, block.rows.rows());
      first += block.rows.rows();
      const Block named{block.group, block.unknowns, block.parameters};
      const Eigen::MatrixXd half = factor->half_solved(named, block.rows.leftCols(block.rows.cols() - 1));
      EXPECT_LT((half.transpose() * half - rows * inverse * rows.transpose()).norm(), 1e-9);
      const Eigen::MatrixXd solved = factor->solved(named, half);
      EXPECT_LT((block.rows.leftCols(block.rows.cols() - 1) * solved - half.transpose() * half).norm(), 1e-9);
      EXPECT_LT((solved.bottomRows(arm_size) - (inverse * rows.transpose()).bottomRows(arm_size)).norm(), 1e-9);
    }
  }
}

TEST(ArrowFactor, ByNormalEquationsItsStepsAreTheSameToHalfOfTheDigits) {
  for (const Artefacts& artefacts : kinds) {
    const Linearisation linearisation = random_linearisation(artefacts);
    const Eigen::MatrixXd all = dense(linearisation);
    const Eigen::VectorXd gradient_there = all.leftCols(linearisation.layout.size).transpose() * all.rightCols<1>();
    const Eigen::VectorXd expected = ArrowFactor::of(linearisation)->solve(gradient_there).numbers;
    const auto factor = ArrowFactor::of(linearisation, Folding::NormalEquations);
    ASSERT_TRUE(factor) << factor.error().text();
    EXPECT_LT((factor->solve(gradient_there).numbers - expected).norm(), 1e-8 * expected.norm());
  }
}

TEST(ArrowFactor, SolvesForCommonNumbersToTheSameBits) {
  RandomStream random(5, "gradient of a group");
  for (const Artefacts& artefacts : kinds) {
    const Linearisation linearisation = random_linearisation(artefacts);
    const StateLayout& layout = linearisation.layout;
    const auto factor = ArrowFactor::of(linearisation);
    ASSERT_TRUE(factor) << factor.error().text();
    for (int group = 0; group < static_cast<int>(layout.groups.size()); ++group) {
      Eigen::VectorXd gradient_there = Eigen::VectorXd::Zero(layout.size);
      auto own = gradient_there.segment(layout.groups[group], 6);
      for (double& number : own) number = random.normal();
      own[2] = 0.0;
      const Eigen::VectorXd expected = factor->solve(gradient_there).numbers.tail(layout.size - layout.common);
      EXPECT_EQ(factor->solve_for_common(group, own), expected) << "group " << group;
    }
  }
}

// Blocks count with weights of their own, some not at all.
TEST(FitSpread, IsThatOfTheDenseInverse) {
  for (const Artefacts& artefacts : kinds) {
    const Linearisation linearisation = random_linearisation(artefacts);
    Linearisation squared = linearisation;
    for (std::size_t b = 0; b < squared.blocks.size(); ++b) {
      squared.blocks[b].rows *= std::vector{1.0, 0.0, 0.3, 0.7, 0.1}[b % 5];
    }
    const Eigen::MatrixXd j = dense(linearisation).leftCols(linearisation.layout.size);
    const Eigen::MatrixXd weighted = dense(squared).leftCols(linearisation.layout.size);
    const Eigen::MatrixXd inverse = (j.transpose() * j).inverse();
    const auto factor = ArrowFactor::of(linearisation);
    ASSERT_TRUE(factor) << factor.error().text();
    const FitSpread spread(*factor, squared, arm_size);
    Eigen::Index first = 0;
    for (const BlockRows& block : linearisation.blocks) {
      const Eigen::MatrixXd seen = weighted * inverse * j.middleRows(first, block.rows.rows()).transpose();
      first += block.rows.rows();
      const Block named{block.group, block.unknowns, block.parameters};
      const Eigen::MatrixXd solved =
          factor->fully_solved(named, factor->half_solved(named, block.rows.leftCols(block.rows.cols() - 1)));
      EXPECT_LT((spread.of(named, solved) - seen.transpose() * seen).norm(), 1e-9);
    }
  }
}

// Elements of all eliminated rows: what elimination and solving take time for.
std::size_t work_of(const Linearisation& linearisation) {
  std::vector<EliminatedRows> eliminated;
  eliminate_nuisance(linearisation, arm_size, &eliminated);
  std::size_t elements = 0;
  for (const EliminatedRows& rows : eliminated) {
    elements += rows.own.size() + rows.by_rest.size() + rows.by_trailing.size();
  }
  return elements;
}

TEST(Elimination, WorkGrowsInProportionToFeaturesAndToPlacements) {
  const auto work = [](int placements, int features) {
    return static_cast<double>(work_of(random_linearisation({{{placements, features}}, 4, {3}})));
  };
  EXPECT_LT(work(4, 160) / work(4, 80), 2.1);
  EXPECT_LT(work(160, 4) / work(80, 4), 2.1);
  const auto many_artefacts = [](std::size_t count) {
    return static_cast<double>(work_of(random_linearisation({std::vector<std::pair<int, int>>(count, {1, 2})})));
  };
  EXPECT_LT(many_artefacts(160) / many_artefacts(80), 2.1);
}

}  // namespace
}  // namespace artcal
