#include "artefacts/verification/sphere_plate/swing_round.h"

#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "artefacts/artefact/artefact_file.h"
#include "artefacts/artefact/artefact_text.h"
#include "core/random.h"
#include "core/rigid.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

// An arm whose x axis is 20 ppm long and whose y axis leans by 10 µrad.
Eigen::Matrix3d arm_error() {
  Eigen::Matrix3d error = Eigen::Matrix3d::Identity();
  error(0, 0) += 20e-6;
  error(0, 1) = 10e-6;
  return error;
}

struct Swing {
  Eigen::Matrix3Xd certified{3, 25}, truth{3, 25};
  std::vector<Eigen::Matrix3Xd> placements;

  Swing(int count, double turn, double noise) {
    RandomStream random(9, "swing-round");
    for (int i = 0; i < 25; ++i) {
      certified.col(i) = Eigen::Vector3d(100.0 * (i % 5) - 200.0, 100.0 * (i / 5) - 200.0, 0.0);
    }
    truth = certified + 0.005 * Eigen::Matrix3Xd::NullaryExpr(3, 25, [&] { return random.normal(); });
    for (int i = 0; i < count; ++i) {
      const Eigen::Matrix3d rotation = Eigen::AngleAxisd(i * turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      placements.push_back(((arm_error() * rotation * truth).colwise() + Eigen::Vector3d(500.0, 300.0, 0.0)) +
                           noise * Eigen::Matrix3Xd::NullaryExpr(3, 25, [&] { return random.normal(); }));
    }
  }
  /// Largest error of the shape found, the common scale of the arm (half of 20 ppm) taken out.
  [[nodiscard]] double error(const PlateCalibration& found) const {
    // Both in the certificate's frame by the same best motion: shift and turn of 5 µm of deviations are within µm.
    const auto onto = mean_shape({truth, truth}, certified);
    return (found.centres / (1.0 + 10e-6) - onto->centres).colwise().norm().maxCoeff();
  }
};

TEST(SwingRound, FourQuartersTakeTheArmsErrorsOut) {
  const Swing swing(4, std::numbers::pi / 2, 0.0);
  const auto found = mean_shape(swing.placements, swing.certified);
  ASSERT_TRUE(found);
  EXPECT_LT(swing.error(*found), 1e-5);
  EXPECT_NEAR(found->least_turn, std::numbers::pi / 2, 1e-4);
  EXPECT_EQ(found->placements, 4);
  EXPECT_GT(found->u.maxCoeff(), 0.5e-3);  // the arm's errors are in the scatter
}

TEST(SwingRound, UnturnedPlacementsDoNot) {
  const Swing swing(4, 0.01, 0.0);
  const auto found = mean_shape(swing.placements, swing.certified);
  EXPECT_GT(swing.error(*found), 1e-3);
  EXPECT_NEAR(found->least_turn, 0.01, 1e-3);
}

TEST(SwingRound, NoiseAveragesAsItsUncertaintySays) {
  Swing swing(4, std::numbers::pi / 2, 0.002);
  for (auto& placement : swing.placements) {
    placement = arm_error().inverse() * placement;
  }
  const auto found = mean_shape(swing.placements, swing.certified);
  const auto onto = mean_shape({swing.truth, swing.truth}, swing.certified);
  const double rms = std::sqrt((found->centres - onto->centres).squaredNorm() / 75.0);
  EXPECT_NEAR(rms, 0.001, 0.0002);  // 2 µm over √4
  EXPECT_NEAR(std::sqrt(found->u.squaredNorm() / 25.0), 0.001, 0.0002);
}

// Two placements of four balls: 12 coordinates each, of which a pose takes six, so that each ball has 3/2 degrees of
// freedom, and Student's factor is 6 (scipy 1.10, t.ppf(0.975, 1.5) = 6.017). U of its coordinates holds their error.
TEST(SwingRound, UOfFewPlacementsHoldsAsOftenAsItSays) {
  RandomStream random(12, "two placements");
  Eigen::Matrix3Xd plate(3, 4);
  plate << 0, 200, 200, 0, 0, 0, 200, 200, 0, 0, 0, 0;
  int inside = 0, all = 0;
  for (int run = 0; run < 500; ++run) {
    std::vector<Eigen::Matrix3Xd> placements;
    for (int i = 0; i < 2; ++i) {
      placements.push_back(plate + 0.002 * Eigen::Matrix3Xd::NullaryExpr(3, 4, [&] { return random.normal(); }));
    }
    const auto found = mean_shape(placements, plate);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->degrees_of_freedom, 1.5, 1e-12);
    for (int ball = 0; ball < 4; ++ball) {
      for (int axis = 0; axis < 3; ++axis) {
        inside += std::abs(found->deviations(axis, ball)) < 6.017 * found->u(ball) ? 1 : 0;
        ++all;
      }
    }
  }
  EXPECT_GT(static_cast<double>(inside) / all, 0.93);
}

TEST(SwingRound, ACalibratedPlateIsAnArtefactFileWithItsU) {
  const Swing swing(4, std::numbers::pi / 2, 0.001);
  auto found = mean_shape(swing.placements, swing.certified);
  ASSERT_TRUE(found);
  Artefact certified;
  certified.name = "plate";
  certified.type = ArtefactType::SpherePlate;
  certified.certificate.number = "old";
  certified.distances = {{0, 1, 100.0, 1e-3}};
  for (int i = 0; i < 25; ++i) {
    CertifiedFeature ball;
    ball.name = std::to_string(i);
    ball.kind = FeatureKind::Sphere;
    ball.radius = 10.0;
    ball.at = swing.certified.col(i);
    certified.features.push_back(ball);
    found->features.push_back(ball.name);
  }
  const testing::TemporaryFolder folder;
  const auto read =
      read_artefact_file(folder.write("plate.toml", artefact_file_text(calibrated_artefact(certified, *found), {})));
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->artefact.features.size(), 25u);
  for (int i = 0; i < 25; ++i) {
    const CertifiedFeature& ball = read->artefact.features[static_cast<std::size_t>(i)];
    EXPECT_EQ(ball.name, std::to_string(i));
    EXPECT_EQ(*ball.at, found->centres.col(i));
    EXPECT_NEAR(ball.u_at, found->u(i), 1e-15);
    EXPECT_EQ(ball.radius, 10.0);
  }
  EXPECT_TRUE(read->artefact.distances.empty());
  EXPECT_EQ(read->artefact.certificate.number, "");
  EXPECT_NE(read->artefact.note.find("The scale is the arm's"), std::string::npos);
}

}  // namespace
}  // namespace artcal
